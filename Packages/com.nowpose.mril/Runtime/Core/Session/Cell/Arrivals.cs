using System.Collections.Concurrent;

namespace Nowpose.Session.Cell
{
    /// <summary>Queue of messages for the next frame, with their arrival times. Drops the oldest when full. Thread-safe.</summary>
    sealed class Arrivals<T>
    {
        readonly ConcurrentQueue<(T Message, HeadsetTime At)> _queue = new ConcurrentQueue<(T, HeadsetTime)>();
        readonly int _capacity;

        public Arrivals(int capacity) => _capacity = capacity;

        /// <param name="dropped">The oldest message, if the queue was full.</param>
        /// <returns>Whether a message was dropped.</returns>
        public bool Add(T message, HeadsetTime at, out T dropped) => Add(message, at, out dropped, out _);

        /// <param name="dropped">The oldest message, if the queue was full.</param>
        /// <param name="droppedAt">Arrival time of the dropped message.</param>
        /// <returns>Whether a message was dropped.</returns>
        public bool Add(T message, HeadsetTime at, out T dropped, out HeadsetTime droppedAt)
        {
            _queue.Enqueue((message, at));
            (dropped, droppedAt) = default((T, HeadsetTime));
            return _queue.Count > _capacity && TryTake(out dropped, out droppedAt);
        }

        public bool TryTake(out T message, out HeadsetTime at)
        {
            var isTaken = _queue.TryDequeue(out var oldest);
            (message, at) = oldest;
            return isTaken;
        }
    }
}
