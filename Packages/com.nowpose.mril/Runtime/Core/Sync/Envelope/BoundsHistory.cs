using System;

namespace Nowpose.Sync.Envelope
{
    /// <summary>Bounds of the newest exchanges, newest first, limited by count and age. Allocates nothing after construction.</summary>
    sealed class BoundsHistory
    {
        readonly OffsetBounds[] _ring;
        readonly TimeSpan _oldest;
        int _newest;

        /// <param name="most">Maximum number of exchanges.</param>
        /// <param name="oldest">Maximum age of an exchange relative to the newest exchange.</param>
        public BoundsHistory(int most, TimeSpan oldest)
        {
            _ring = new OffsetBounds[most];
            _oldest = oldest;
        }

        public int Count { get; private set; }

        /// <param name="age">Index from 0, the newest, to <see cref="Count"/> − 1, the oldest.</param>
        public ref readonly OffsetBounds this[int age] => ref _ring[Place(age)];

        public void Add(in OffsetBounds bounds)
        {
            _newest = (_newest + 1) % _ring.Length;
            _ring[_newest] = bounds;
            if (Count < _ring.Length) Count++;
            while (bounds.Received - this[Count - 1].Received > _oldest) Count--;
        }

        /// <summary>Moves the bounds of one exchange; the amounts are in ticks.</summary>
        public void Shift(int age, long lower, long upper)
        {
            ref var bounds = ref _ring[Place(age)];
            bounds = bounds.Shifted(lower, upper);
        }

        public void Clear() => Count = 0;

        // Avoids the modulo operator, because its division would take longer than the rest of most loops over the history.
        int Place(int age) => age <= _newest ? _newest - age : _newest - age + _ring.Length;
    }
}
