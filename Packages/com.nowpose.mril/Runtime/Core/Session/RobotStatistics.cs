using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>State of one robot of a session at one time.</summary>
    sealed class RobotStatistics
    {
        /// <summary>Namespace of the robot; empty for a robot without a namespace.</summary>
        public string Namespace { get; set; } = "";

        /// <summary>State of the robot's pose.</summary>
        public PoseState Pose { get; set; }

        /// <inheritdoc cref="DisplayFrame.SettledState"/>
        public PoseState SettledPose { get; set; }

        /// <inheritdoc cref="DisplayFrame.IsSettledLimitedByBase"/>
        public bool IsSettledLimitedByBase { get; set; }

        /// <inheritdoc cref="SessionStatistics.JointStatuses"/>
        public List<JointStatus> JointStatuses { get; } = new List<JointStatus>();

        public RobotDescriptionMatch DescriptionMatch { get; set; }

        /// <inheritdoc cref="SessionStatistics.BeyondLimits"/>
        public JointBeyondLimits BeyondLimits { get; set; }

        /// <summary>
        /// Whether time stamps of the joint positions are ahead of the control clock, so that the robot is displayed too late or not at all.
        /// </summary>
        public bool AreStampsAhead { get; set; }

        /// <summary>Message about the time stamps of the samples; null if nothing is wrong with them. It can be the reason of joints without data.</summary>
        public string StampProblem => AreStampsAhead ? RobotMessages.StampsAhead : null;

        /// <summary>Message about the content of the samples; null if nothing is wrong with it.</summary>
        public string SampleProblem => BeyondLimits?.Words ?? StampProblem;

        /// <summary>Number of used messages.</summary>
        public long Samples { get; set; }

        /// <summary>Message if the robot has received no samples, and the gateway serves robots only in other namespaces; null otherwise.</summary>
        public string OtherNamespaces { get; set; }

        /// <summary>Returns the cell-wide name of one of the robot's joints.</summary>
        public string NameOf(string joint) => RobotTopic.Qualified(Namespace, joint);
    }
}
