using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>A message of joint samples with its arrival time.</summary>
    readonly struct SampleArrival
    {
        public SampleArrival(JointStateMessage message, HeadsetTime at)
        {
            Message = message;
            At = at;
        }

        public JointStateMessage Message { get; }

        /// <summary>Headset time at which the last byte of the message was read.</summary>
        public HeadsetTime At { get; }
    }

    /// <summary>A message of set-points with its arrival time.</summary>
    readonly struct PlanArrival
    {
        public PlanArrival(JointTrajectoryMessage message, HeadsetTime at)
        {
            Message = message;
            At = at;
        }

        public JointTrajectoryMessage Message { get; }

        /// <summary>Headset time at which the last byte of the message was read.</summary>
        public HeadsetTime At { get; }
    }
}
