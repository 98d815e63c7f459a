using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>A message of set-points and when it arrived.</summary>
    readonly struct PlanArrival
    {
        public PlanArrival(JointTrajectoryMessage message, HeadsetTime at)
        {
            Message = message;
            At = at;
        }

        public JointTrajectoryMessage Message { get; }

        /// <summary>When its last byte was read, on the headset clock.</summary>
        public HeadsetTime At { get; }
    }
}
