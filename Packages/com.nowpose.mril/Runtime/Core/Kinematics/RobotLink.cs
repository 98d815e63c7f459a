using System.Collections.Generic;

namespace Nowpose.Kinematics
{
    /// <summary>A rigid part of a robot. Its frame is the frame of its parent joint.</summary>
    public sealed class RobotLink
    {
        internal RobotLink(string name, RobotJoint parentJoint, int parentIndex, IReadOnlyList<LinkVisual> visuals) =>
            (Name, ParentJoint, ParentIndex, Visuals) = (name, parentJoint, parentIndex, visuals);

        public string Name { get; }

        /// <summary>Joint that connects the link to its parent; null for the root link.</summary>
        public RobotJoint ParentJoint { get; }

        /// <summary>Index of the parent in <see cref="RobotModel.Links"/>, always lower than the link's own; -1 for the root link.</summary>
        public int ParentIndex { get; }

        internal IReadOnlyList<LinkVisual> Visuals { get; }

        public override string ToString() => Name;
    }
}
