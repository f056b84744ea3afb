"""PlatformIO for tests/release.sh. It would fetch the names of all licences."""

from platformio.__main__ import main
from platformio.package.manifest.schema import ManifestSchema

ManifestSchema.load_spdx_licenses = lambda self: {"licenses": [{"licenseId": "MIT"}, {"licenseId": "Apache-2.0"}]}
raise SystemExit(main())
