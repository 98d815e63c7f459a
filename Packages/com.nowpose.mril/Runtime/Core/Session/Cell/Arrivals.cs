using System.Collections.Concurrent;

namespace Nowpose.Session.Cell
{
    /// <summary>Messages that wait for the next frame, with their arrival times. Drops the oldest when full. Thread-safe.</summary>
    sealed class Arrivals<T>
    {
        readonly ConcurrentQueue<(T Message, HeadsetTime At)> _queue = new ConcurrentQueue<(T, HeadsetTime)>();
        readonly int _capacity;

        public Arrivals(int capacity) => _capacity = capacity;

        /// <param name="dropped">The oldest message, if the queue was full.</param>
        /// <returns>Whether a message was dropped.</returns>
        public bool Add(T message, HeadsetTime at, out T dropped)
        {
            _queue.Enqueue((message, at));
            dropped = default;
            if (_queue.Count <= _capacity || !_queue.TryDequeue(out var oldest)) return false;
            dropped = oldest.Message;
            return true;
        }

        public bool TryTake(out T message, out HeadsetTime at)
        {
            var isTaken = _queue.TryDequeue(out var oldest);
            (message, at) = oldest;
            return isTaken;
        }
    }
}
