using System.Collections.Generic;

namespace Nowpose.Protocol
{
    /// <summary>A publication on /nowpose/joint_status: the joints that are not live. Empty if all joints are live.</summary>
    sealed class JointStatusMessage
    {
        public JointStatusMessage(IReadOnlyList<JointReport> joints) => Joints = joints;

        public IReadOnlyList<JointReport> Joints { get; }
    }
}
