# Reads the table of chips. CHIPS are the names of their archives: the target, and the processor if the table has one.
# $(call choices,NAME) and the others are columns of the chip's row.

rows := $(shell sed -n '/| TARGET=/{s/ *| */|/g; s/ /~/g; p}' $(dir $(lastword $(MAKEFILE_LIST)))chips.txt)
name_of = $(subst ~CPU=,-,$(patsubst TARGET=%,%,$(word 2,$(subst |, ,$1))))
CHIPS := $(foreach row,$(rows),$(call name_of,$(row)))
$(foreach row,$(rows),$(eval row_$(call name_of,$(row)) := $(subst |, ,$(row))))
column = $(subst ~, ,$(word $2,$(row_$1)))
choices = $(call column,$1,2)
compiler = $(call column,$1,3)
calls = $(call column,$1,4)
memory = $(filter-out -,$(call column,$1,5))
board = $(call column,$1,6)
