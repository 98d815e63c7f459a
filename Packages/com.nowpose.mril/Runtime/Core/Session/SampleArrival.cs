using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>A message and when it arrived.</summary>
    readonly struct SampleArrival
    {
        public SampleArrival(JointStateMessage message, HeadsetTime at)
        {
            Message = message;
            At = at;
        }

        public JointStateMessage Message { get; }

        /// <summary>When its last byte was read, on the headset clock.</summary>
        public HeadsetTime At { get; }
    }
}
