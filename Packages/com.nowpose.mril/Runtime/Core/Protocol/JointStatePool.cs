using System.Collections.Concurrent;

namespace Nowpose.Protocol
{
    /// <summary>Keeps messages that their last user returned, for reuse. Any thread; bounded.</summary>
    sealed class JointStatePool
    {
        /// <summary>A source at 1 kHz leaves 17 messages for a frame at 60 Hz. More, after a stall, are left to the garbage collector.</summary>
        const int Capacity = 32;

        readonly ConcurrentQueue<JointStateMessage> _free = new ConcurrentQueue<JointStateMessage>();

        public JointStateMessage Take(int joints)
        {
            // Of sources that publish in turns, the one with as many joints is among the first.
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
