using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>A message of set-points with its arrival time.</summary>
    readonly struct PlanArrival
    {
        public PlanArrival(JointTrajectoryMessage message, HeadsetTime at)
        {
            Message = message;
            At = at;
        }

        public JointTrajectoryMessage Message { get; }

        /// <summary>Headset time at which its last byte was read.</summary>
        public HeadsetTime At { get; }
    }
}
