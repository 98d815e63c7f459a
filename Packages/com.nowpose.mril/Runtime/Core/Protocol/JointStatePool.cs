using System.Collections.Concurrent;

namespace Nowpose.Protocol
{
    /// <summary>Keeps returned messages for reuse, up to a maximum number. Thread-safe.</summary>
    sealed class JointStatePool
    {
        /// <summary>
        /// Maximum number of kept messages. At 60 frames per second, a source at 1 kHz sends 17 messages per frame; the pool discards messages
        /// beyond this number, for example after a stall.
        /// </summary>
        const int Capacity = 32;

        readonly ConcurrentQueue<JointStateMessage> _free = new ConcurrentQueue<JointStateMessage>();

        public JointStateMessage Take(int joints)
        {
            // With several alternating sources, a message with the right number of joints is near the front.
            for (var left = _free.Count; left > 0 && _free.TryDequeue(out var message); left--)
            {
                if (message.Positions.Length == joints) return message;
                _free.Enqueue(message);
            }

            return new JointStateMessage(joints, this);
        }

        public void Return(JointStateMessage message)
        {
            if (_free.Count < Capacity) _free.Enqueue(message);
        }
    }
}
