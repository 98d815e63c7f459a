using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Messages;

namespace Nowpose.Kinematics
{
    /// <summary>Sorts mimic joints so that masters precede their followers.</summary>
    static class UrdfMimics
    {
        public static MimicStep[] InOrder(UrdfSource source, UrdfJoint[] joints)
        {
            var byName = joints.ToDictionary(joint => joint.Joint.Name, StringComparer.Ordinal);
            var steps = new List<MimicStep>();
            var done = new HashSet<UrdfJoint>();
            foreach (var joint in joints)
            {
                // Follows the masters up to a joint that is not a mimic joint or is already in the list; the stack reverses the order.
                var chain = new Stack<UrdfJoint>();
                var at = joint;
                for (; at.Joint.Mimic != null && done.Add(at); at = Master(source, at, byName)) chain.Push(at);
                if (chain.Contains(at))
                    throw MimicError(
                        source, at, UrdfMessages.MimicCycle(UrdfSource.Quote(at.Joint.Mimic.Master)));
                foreach (var follower in chain) steps.Add(Step(follower.Joint, byName));
            }
            return steps.ToArray();
        }

        static UrdfJoint Master(UrdfSource source, UrdfJoint follower, Dictionary<string, UrdfJoint> byName)
        {
            var name = follower.Joint.Mimic.Master;
            if (!byName.TryGetValue(name, out var master))
                throw MimicError(source, follower, UrdfMessages.UnknownJoint(UrdfSource.Quote(name)));
            if (master.Joint.Kind == JointKind.Fixed)
                throw MimicError(source, follower, UrdfMessages.MimicOfFixed(UrdfSource.Quote(name)));
            return master;
        }

        static InputException MimicError(UrdfSource source, UrdfJoint joint, string message) =>
            source.Error(UrdfSource.Child(joint.Element, "mimic"), message);

        static MimicStep Step(RobotJoint follower, Dictionary<string, UrdfJoint> byName) => new MimicStep(
            follower.MovingIndex, byName[follower.Mimic.Master].Joint.MovingIndex, follower.Mimic.Multiplier, follower.Mimic.Offset);
    }

    /// <summary>A mimic joint with indices instead of names. In a model, masters precede their followers.</summary>
    readonly struct MimicStep
    {
        public MimicStep(int joint, int master, double multiplier, double offset) =>
            (Joint, Master, Multiplier, Offset) = (joint, master, multiplier, offset);

        public int Joint { get; }
        public int Master { get; }
        public double Multiplier { get; }
        public double Offset { get; }
    }
}
