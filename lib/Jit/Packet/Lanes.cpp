#include "Lanes.h"

#include <llvm/Analysis/VectorUtils.h>
#include <llvm/IR/Constants.h>
#include <llvm/IR/GetElementPtrTypeIterator.h>
#include <llvm/IR/Operator.h>

#include <algorithm>

namespace voxc {

Lanes::Lanes(llvm::Function &function, unsigned count, const llvm::TargetTransformInfo &target)
    : function_(function), context_(function.getContext()), layout_(function.getDataLayout()),
      target_(target), count_(count), builder_(function.getContext()) {}

llvm::Value *Lanes::any(llvm::Value *mask) {
  llvm::Value *bits = builder_.CreateBitCast(mask, builder_.getIntNTy(count_));
  return builder_.CreateICmpNE(bits, builder_.getIntN(count_, 0));
}

llvm::Value *Lanes::get(llvm::Value *value) const {
  const auto known = values_.find(value);
  return known == values_.end() ? value : known->second;
}

llvm::Value *Lanes::spread(llvm::Value *value) {
  return value->getType()->isVectorTy() ? value : builder_.CreateVectorSplat(count_, value);
}

bool Lanes::isShared(const llvm::Instruction &instruction) const {
  return std::ranges::none_of(instruction.operands(),
                              [&](const llvm::Use &use) { return get(use)->getType()->isVectorTy(); });
}

llvm::Value *Lanes::clone(llvm::Instruction &instruction) {
  llvm::Instruction *copy = instruction.clone();
  for (llvm::Use &use : copy->operands())
    use.set(get(use));
  copy->dropUnknownNonDebugMetadata();
  return builder_.Insert(copy);
}

llvm::Value *Lanes::arithmetic(llvm::Instruction &instruction, llvm::Value *mask) {
  llvm::Instruction *copy = instruction.clone();
  for (llvm::Use &use : copy->operands())
    use.set(vector(use));
  // A lane that is not at work may hold anything, and a division by 0 would be one of them all.
  if (instruction.isIntDivRem())
    copy->setOperand(1, builder_.CreateSelect(mask, copy->getOperand(1),
                                              spread(llvm::ConstantInt::get(instruction.getType(), 1))));
  copy->dropUnknownNonDebugMetadata();
  copy->mutateType(wide(instruction.getType()));
  return builder_.Insert(copy);
}

llvm::Value *Lanes::intrinsic(llvm::IntrinsicInst &call) {
  const llvm::Intrinsic::ID id = call.getIntrinsicID();
  llvm::SmallVector<llvm::Value *, 4> arguments;
  llvm::SmallVector<llvm::Type *, 2> types = {wide(call.getType())};
  for (unsigned i = 0; i < call.arg_size(); ++i) {
    const bool isScalar = llvm::isVectorIntrinsicWithScalarOpAtArg(id, i);
    arguments.push_back(isScalar ? get(call.getArgOperand(i)) : vector(call.getArgOperand(i)));
    if (llvm::isVectorIntrinsicWithOverloadTypeAtArg(id, static_cast<int>(i)))
      types.push_back(arguments.back()->getType());
  }
  if (!llvm::isVectorIntrinsicWithOverloadTypeAtArg(id, -1))
    types.erase(types.begin());
  llvm::CallInst *wideCall = builder_.CreateIntrinsic(id, types, arguments);
  if (llvm::isa<llvm::FPMathOperator>(call))
    wideCall->copyFastMathFlags(&call);
  return wideCall;
}

/// The memory of all lanes, word by word: what a lane keeps at offset o lies at o * lanes + 4 * its number.
llvm::Value *Lanes::privateMemory(llvm::AllocaInst &memory) {
  const std::uint64_t bytes = layout_.getTypeAllocSize(memory.getAllocatedType());
  llvm::AllocaInst *all =
      builder_.CreateAlloca(llvm::ArrayType::get(builder_.getInt32Ty(), bytes / 4 * count_));
  all->setAlignment(llvm::Align(64));
  llvm::SmallVector<llvm::Constant *, 16> offsets;
  for (unsigned lane = 0; lane < count_; ++lane)
    offsets.push_back(builder_.getInt64(lane));
  private_.insert(&memory);
  return builder_.CreateGEP(builder_.getInt32Ty(), all, llvm::ConstantVector::get(offsets));
}

llvm::Value *Lanes::privateAddress(llvm::GetElementPtrInst &address) {
  private_.insert(&address);
  llvm::Value *offset = llvm::Constant::getNullValue(wide(builder_.getInt64Ty()));
  for (auto step = llvm::gep_type_begin(address); step != llvm::gep_type_end(address); ++step) {
    std::uint64_t stride = step.getSequentialElementStride(layout_);
    llvm::Value *index = nullptr;
    if (llvm::StructType *type = step.getStructTypeOrNull()) {
      const auto field = llvm::cast<llvm::ConstantInt>(step.getOperand())->getZExtValue();
      index = builder_.getInt64(layout_.getStructLayout(type)->getElementOffset(field));
      stride = 1;
    } else {
      index = get(step.getOperand());
    }
    llvm::Value *wideIndex = builder_.CreateSExtOrTrunc(spread(index), wide(builder_.getInt64Ty()));
    offset =
        builder_.CreateAdd(offset, builder_.CreateMul(wideIndex, spread(builder_.getInt64(stride * count_))));
  }
  return builder_.CreateGEP(builder_.getInt8Ty(), vector(address.getPointerOperand()), offset);
}

/// Gathers and scatters want one base for all lanes, and offsets of 32 bits from there.
llvm::Value *Lanes::address(llvm::GetElementPtrInst &address) {
  if (private_.contains(address.getPointerOperand()))
    return privateAddress(address);
  llvm::Value *base = get(address.getPointerOperand());
  llvm::Type *type = address.getSourceElementType();
  llvm::SmallVector<llvm::Value *, 4> indices;
  for (llvm::Use &index : address.indices())
    indices.push_back(get(index));
  const bool isSharedOffset =
      std::ranges::none_of(indices, [](const llvm::Value *index) { return index->getType()->isVectorTy(); });
  // A constant beyond an offset: the base moves on.
  if (const auto known = places_.find(address.getPointerOperand());
      isSharedOffset && known != places_.end()) {
    const Place &place = known->second;
    return setPlace(address, {builder_.CreateGEP(type, place.base, indices), place.type, place.offset});
  }
  if (indices.size() != 1 || base->getType()->isVectorTy())
    return builder_.CreateGEP(type, base, indices);
  // The offsets are signed: an unsigned one is that less 2^31, from a base moved on by 2^31.
  const auto *extended = llvm::dyn_cast<llvm::ZExtInst>(address.getOperand(1));
  if (extended != nullptr && extended->getSrcTy()->isIntegerTy(32)) {
    llvm::Value *number = vector(extended->getOperand(0));
    if (!extended->hasNonNeg()) {
      number = builder_.CreateXor(number, spread(builder_.getInt32(0x80000000u)));
      base = builder_.CreateGEP(type, base, builder_.getInt64(std::int64_t{1} << 31));
    }
    indices[0] = builder_.CreateSExt(number, wide(builder_.getInt64Ty()));
  }
  return setPlace(address, {base, type, indices[0]});
}

llvm::Value *Lanes::setPlace(const llvm::Value &address, const Place &place) {
  places_[&address] = place;
  return builder_.CreateGEP(place.type, place.base, place.offset);
}

/// A word that all lanes share is read once, if there is one at work.
llvm::Value *Lanes::loadShared(llvm::LoadInst &load, llvm::Value *mask) {
  const auto *constant = llvm::dyn_cast<llvm::Constant>(mask);
  if (constant != nullptr && constant->isAllOnesValue())
    return clone(load);
  llvm::BasicBlock *before = builder_.GetInsertBlock();
  llvm::BasicBlock *reads = llvm::BasicBlock::Create(context_, "reads", &function_, before->getNextNode());
  llvm::BasicBlock *next = llvm::BasicBlock::Create(context_, "read", &function_, reads->getNextNode());
  builder_.CreateCondBr(any(mask), reads, next);
  builder_.SetInsertPoint(reads);
  llvm::Value *value = clone(load);
  builder_.CreateBr(next);
  builder_.SetInsertPoint(next);
  llvm::PHINode *result = builder_.CreatePHI(load.getType(), 2);
  result->addIncoming(value, reads);
  result->addIncoming(llvm::PoisonValue::get(load.getType()), before);
  return result;
}

llvm::Value *Lanes::load(llvm::LoadInst &load, llvm::Value *mask) {
  llvm::Value *address = get(load.getPointerOperand());
  if (!address->getType()->isVectorTy())
    return loadShared(load, mask);
  if (!target_.isLegalMaskedGather(wide(load.getType()), load.getAlign()))
    return loadEach(load, address, mask);
  return builder_.CreateMaskedGather(wide(load.getType()), address, load.getAlign(), mask);
}

/// Addresses of which lanes that are not at work have one on the stack, so that no branch is needed where a
/// processor has neither gathers nor scatters.
llvm::Value *Lanes::harmless(llvm::Value *addresses, llvm::Value *mask) {
  if (unused_ == nullptr) {
    llvm::BasicBlock &entry = function_.getEntryBlock();
    unused_ = llvm::IRBuilder<>(&entry, entry.begin()).CreateAlloca(builder_.getInt64Ty());
  }
  return builder_.CreateSelect(mask, addresses, spread(unused_));
}

llvm::Value *Lanes::loadEach(const llvm::LoadInst &load, llvm::Value *addresses, llvm::Value *mask) {
  llvm::Value *from = harmless(addresses, mask);
  llvm::Value *result = llvm::PoisonValue::get(wide(load.getType()));
  for (unsigned lane = 0; lane < count_; ++lane) {
    llvm::Value *address = builder_.CreateExtractElement(from, lane);
    llvm::Value *word = builder_.CreateAlignedLoad(load.getType(), address, load.getAlign());
    result = builder_.CreateInsertElement(result, word, lane);
  }
  return result;
}

llvm::Value *Lanes::store(llvm::StoreInst &store, llvm::Value *mask) {
  llvm::Value *values = vector(store.getValueOperand());
  llvm::Value *addresses = vector(store.getPointerOperand());
  if (target_.isLegalMaskedScatter(values->getType(), store.getAlign()))
    return builder_.CreateMaskedScatter(values, addresses, store.getAlign(), mask);
  llvm::Value *to = harmless(addresses, mask);
  llvm::Value *last = nullptr;
  for (unsigned lane = 0; lane < count_; ++lane)
    last = builder_.CreateAlignedStore(builder_.CreateExtractElement(values, lane),
                                       builder_.CreateExtractElement(to, lane), store.getAlign());
  return last;
}

/// True if an address of memory that each lane has of its own goes where it is not known to be one.
bool Lanes::losesPrivate(const llvm::Instruction &instruction) const {
  const llvm::Value *address = llvm::getLoadStorePointerOperand(&instruction);
  const auto *element = llvm::dyn_cast<llvm::GetElementPtrInst>(&instruction);
  address = element != nullptr ? element->getPointerOperand() : address;
  return std::ranges::any_of(instruction.operands(),
                             [&](const llvm::Use &use) { return private_.contains(use) && use != address; });
}

llvm::Value *Lanes::call(llvm::CallInst &call, llvm::Value *mask) {
  const llvm::Function *callee = call.getCalledFunction();
  if (callee != nullptr && callee->getName() == kLaneNumber) {
    llvm::SmallVector<llvm::Constant *, 16> numbers;
    for (unsigned lane = 0; lane < count_; ++lane)
      numbers.push_back(builder_.getInt32(lane));
    return llvm::ConstantVector::get(numbers);
  }
  if (callee != nullptr && callee->getName() == kLanesAtWork) {
    llvm::Value *bits = builder_.CreateBitCast(mask, builder_.getIntNTy(count_));
    llvm::Value *number = builder_.CreateUnaryIntrinsic(llvm::Intrinsic::ctpop, bits);
    return builder_.CreateZExt(number, builder_.getInt32Ty());
  }
  auto *known = llvm::dyn_cast<llvm::IntrinsicInst>(&call);
  if (known == nullptr || !llvm::isTriviallyVectorizable(known->getIntrinsicID()))
    return nullptr;
  return isShared(call) ? clone(call) : intrinsic(*known);
}

llvm::Value *Lanes::widened(llvm::Instruction &instruction, llvm::Value *mask) {
  if (auto *called = llvm::dyn_cast<llvm::CallInst>(&instruction))
    return call(*called, mask);
  if (losesPrivate(instruction))
    return nullptr;
  if (auto *memory = llvm::dyn_cast<llvm::AllocaInst>(&instruction))
    return privateMemory(*memory);
  if (auto *element = llvm::dyn_cast<llvm::GetElementPtrInst>(&instruction))
    return isShared(instruction) ? clone(instruction) : address(*element);
  const llvm::Value *pointer = llvm::getLoadStorePointerOperand(&instruction);
  if (private_.contains(pointer) && !isWord(llvm::getLoadStoreType(&instruction)))
    return nullptr;
  if (auto *read = llvm::dyn_cast<llvm::LoadInst>(&instruction))
    return load(*read, mask);
  if (auto *written = llvm::dyn_cast<llvm::StoreInst>(&instruction))
    return store(*written, mask);
  if (instruction.isBinaryOp() || instruction.isUnaryOp() || instruction.isCast() ||
      llvm::isa<llvm::CmpInst, llvm::SelectInst, llvm::FreezeInst>(instruction))
    return isShared(instruction) && !instruction.isIntDivRem() ? clone(instruction)
                                                               : arithmetic(instruction, mask);
  return nullptr;
}

bool Lanes::write(llvm::Instruction &instruction, llvm::Value *mask) {
  const auto *known = llvm::dyn_cast<llvm::IntrinsicInst>(&instruction);
  if (known != nullptr && (known->isLifetimeStartOrEnd() || known->isAssumeLikeIntrinsic()))
    return true; // Says nothing that lanes need.
  llvm::Value *lanes = widened(instruction, mask);
  if (lanes != nullptr)
    set(&instruction, lanes);
  return lanes != nullptr;
}

} // namespace voxc
