using System;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>A queue of fixed capacity whose elements are created once and then reused.</summary>
    /// <remarks>
    /// The next element to be filled is the one that was dropped last, because its memory is still in the processor's cache. A ring buffer would fill
    /// the element that was dropped longest ago; with 200 axes, it takes 10 % more time per sample.
    /// </remarks>
    sealed class RecyclingQueue<T> where T : class
    {
        // Used elements, the oldest first, followed by the free elements, the last dropped one first.
        readonly T[] _elements;

        /// <param name="create">Creates one element.</param>
        public RecyclingQueue(int capacity, Func<T> create)
        {
            _elements = new T[capacity];
            for (var i = 0; i < capacity; i++) _elements[i] = create();
        }

        public int Count { get; private set; }

        /// <summary>Index 0 is the oldest.</summary>
        public T this[int index] => _elements[index];

        /// <summary>Appends an element with its previous contents. Drops the oldest when full.</summary>
        public T Append()
        {
            if (Count == _elements.Length) DropFirst();
            return _elements[Count++];
        }

        /// <summary>Drops the oldest element.</summary>
        public void DropFirst()
        {
            var dropped = _elements[0];
            Count--;
            Array.Copy(_elements, 1, _elements, 0, Count);
            _elements[Count] = dropped;
        }

        public void Clear() => Count = 0;
    }
}
