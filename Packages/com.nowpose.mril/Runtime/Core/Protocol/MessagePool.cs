using System.Collections.Concurrent;

namespace Nowpose.Protocol
{
    /// <summary>Keeps returned messages for reuse, up to a maximum number. Thread-safe.</summary>
    sealed class MessagePool<T>
        where T : class
    {
        /// <summary>
        /// Maximum number of kept messages. At 60 frames per second, a source at 1 kHz sends 17 messages per frame; the pool discards messages
        /// beyond this number, for example after a stall.
        /// </summary>
        const int Capacity = 32;

        readonly ConcurrentQueue<T> _free = new ConcurrentQueue<T>();

        /// <summary>Number of kept messages.</summary>
        public int Count => _free.Count;

        /// <summary>Takes a returned message; false if there is none.</summary>
        public bool TryTake(out T message) => _free.TryDequeue(out message);

        public void Return(T message)
        {
            if (Count < Capacity) _free.Enqueue(message);
        }
    }
}
