// The values of a packet: one for all lanes where they agree, else a vector of one for each.
#pragma once

#include <llvm/ADT/DenseMap.h>
#include <llvm/ADT/DenseSet.h>
#include <llvm/Analysis/TargetTransformInfo.h>
#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Instructions.h>
#include <llvm/IR/IntrinsicInst.h>

namespace voxc {

/// What a function for one lane calls to know its number; the argument says how many lanes there are.
inline constexpr const char *kLaneNumber = "voxc_lane_number";

/// What a function calls to know how many lanes are at work.
inline constexpr const char *kLanesAtWork = "voxc_lanes_at_work";

/// Writes the instructions of a function for one lane as instructions for all.
class Lanes {
public:
  Lanes(llvm::Function &function, unsigned count, const llvm::TargetTransformInfo &target);

  llvm::IRBuilder<> &builder() { return builder_; }
  llvm::Type *wide(llvm::Type *type) const { return llvm::FixedVectorType::get(type, count_); }
  llvm::Type *maskType() const { return wide(llvm::Type::getInt1Ty(context_)); }
  llvm::Value *allLanes() const { return llvm::Constant::getAllOnesValue(maskType()); }
  llvm::Value *noLane() const { return llvm::Constant::getNullValue(maskType()); }
  /// A number that is not 0 if any lane is in a mask.
  llvm::Value *any(llvm::Value *mask);

  /// What stands for a value: itself, if all lanes share it, or a vector.
  llvm::Value *get(llvm::Value *value) const;
  /// The same as a vector, always.
  llvm::Value *vector(llvm::Value *value) { return spread(get(value)); }
  llvm::Value *spread(llvm::Value *value);
  void set(const llvm::Value *value, llvm::Value *lanes) { values_[value] = lanes; }

  /// Writes an instruction that is no phi and no terminator, for the lanes of a mask. False if it is of a
  /// kind that is not known here.
  bool write(llvm::Instruction &instruction, llvm::Value *mask);

private:
  /// An address that all lanes share, and how many values of a type each is beyond it.
  struct Place {
    llvm::Value *base;
    llvm::Type *type;
    llvm::Value *offset;
  };

  bool isShared(const llvm::Instruction &instruction) const;
  bool losesPrivate(const llvm::Instruction &instruction) const;
  llvm::Value *widened(llvm::Instruction &instruction, llvm::Value *mask);
  llvm::Value *call(llvm::CallInst &call, llvm::Value *mask);
  llvm::Value *clone(llvm::Instruction &instruction);
  llvm::Value *arithmetic(llvm::Instruction &instruction, llvm::Value *mask);
  llvm::Value *intrinsic(llvm::IntrinsicInst &call);
  llvm::Value *address(llvm::GetElementPtrInst &address);
  llvm::Value *setPlace(const llvm::Value &address, const Place &place);
  llvm::Value *privateMemory(llvm::AllocaInst &memory);
  llvm::Value *privateAddress(llvm::GetElementPtrInst &address);
  llvm::Value *load(llvm::LoadInst &load, llvm::Value *mask);
  llvm::Value *loadShared(llvm::LoadInst &load, llvm::Value *mask);
  llvm::Value *loadEach(const llvm::LoadInst &load, llvm::Value *addresses, llvm::Value *mask);
  llvm::Value *store(llvm::StoreInst &store, llvm::Value *mask);
  llvm::Value *harmless(llvm::Value *addresses, llvm::Value *mask);
  bool isWord(llvm::Type *type) const { return type->isIntegerTy(32) || type->isFloatTy(); }

  llvm::Function &function_;
  llvm::LLVMContext &context_;
  const llvm::DataLayout &layout_;
  const llvm::TargetTransformInfo &target_;
  unsigned count_;
  llvm::IRBuilder<> builder_;
  llvm::AllocaInst *unused_ = nullptr; ///< Where lanes that are not at work read and write.
  llvm::DenseMap<const llvm::Value *, llvm::Value *> values_;
  llvm::DenseMap<const llvm::Value *, Place> places_;
  llvm::DenseSet<const llvm::Value *> private_; ///< Addresses of memory that each lane has of its own.
};

} // namespace voxc
