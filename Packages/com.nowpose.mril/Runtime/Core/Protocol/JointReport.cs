using System.Collections.Generic;

namespace Nowpose.Protocol
{
    /// <summary>The gateway's status of one joint.</summary>
    readonly struct JointReport
    {
        /// <param name="reason">Reason in one line; empty if there is none.</param>
        public JointReport(string joint, JointDataState state, ControlTime since, string reason) =>
            (Joint, State, Since, Reason) = (joint, state, since, reason);

        /// <summary>The joint's name in the URDF.</summary>
        public string Joint { get; }

        public JointDataState State { get; }

        /// <summary>Time at which <see cref="State"/> began.</summary>
        public ControlTime Since { get; }

        public string Reason { get; }
    }

    /// <summary>A publication on /nowpose/joint_status: the joints that are not live. Empty if all joints are live.</summary>
    sealed class JointStatusMessage
    {
        public JointStatusMessage(IReadOnlyList<JointReport> joints) => Joints = joints;

        public IReadOnlyList<JointReport> Joints { get; }
    }
}
