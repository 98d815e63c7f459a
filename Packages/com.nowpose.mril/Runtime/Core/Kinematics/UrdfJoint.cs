using System.Collections.Generic;
using System.Xml.Linq;
using Nowpose.Messages;

namespace Nowpose.Kinematics
{
    /// <summary>A joint of the URDF, with its XML element for error messages.</summary>
    sealed class UrdfJoint
    {
        const double MinAxisLength = 1e-9;

        UrdfJoint(XElement element, RobotJoint joint) => (Element, Joint) = (element, joint);

        public XElement Element { get; }
        public RobotJoint Joint { get; }

        public static UrdfJoint[] ReadAll(UrdfSource source, XElement[] elements)
        {
            var joints = new UrdfJoint[elements.Length];
            var names = new HashSet<string>();
            var moving = 0;
            for (var i = 0; i < elements.Length; i++)
            {
                joints[i] = Read(source, elements[i], moving);
                if (!names.Add(joints[i].Joint.Name)) throw source.Error(elements[i], UrdfMessages.JointTwice);
                if (joints[i].Joint.Kind != JointKind.Fixed) moving++;
            }
            return joints;
        }

        static UrdfJoint Read(UrdfSource source, XElement element, int movingIndex)
        {
            var name = source.RequiredName(element, "name");
            var kind = Kind(source, element);
            var moves = kind != JointKind.Fixed;
            return new UrdfJoint(element, new RobotJoint(
                name, kind, LinkNamed(source, element, "parent"), LinkNamed(source, element, "child"), moves ? movingIndex : -1,
                source.Origin(element),
                moves ? Axis(source, element) : (1, 0, 0),
                moves ? Limits(source, element, kind) : JointLimits.None,
                moves ? Mimic(source, element) : null));
        }

        static JointKind Kind(UrdfSource source, XElement element)
        {
            var type = source.RequiredName(element, "type");
            switch (type)
            {
                case "fixed": return JointKind.Fixed;
                case "revolute": return JointKind.Revolute;
                case "continuous": return JointKind.Continuous;
                case "prismatic": return JointKind.Prismatic;
                default:
                    throw source.Error(element, UrdfMessages.JointType(UrdfSource.Quote(type)));
            }
        }

        static string LinkNamed(UrdfSource source, XElement element, string role)
        {
            var end = UrdfSource.Child(element, role);
            if (end == null) throw source.Error(element, UrdfMessages.LinkMissing(role));
            return source.RequiredName(end, "link");
        }

        static (double, double, double) Axis(UrdfSource source, XElement element)
        {
            var axis = UrdfSource.Child(element, "axis");
            var (x, y, z) = source.Triple(axis, "xyz", (1, 0, 0));
            var length = System.Math.Sqrt(x * x + y * y + z * z);
            if (!(length >= MinAxisLength) || double.IsInfinity(length))
                throw source.Error(axis, UrdfMessages.Axis);
            return (x / length, y / length, z / length);
        }

        static JointLimits Limits(UrdfSource source, XElement element, JointKind kind)
        {
            var limit = UrdfSource.Child(element, "limit");
            if (limit == null) return JointLimits.None;
            double lower = double.NegativeInfinity, upper = double.PositiveInfinity;
            if (kind != JointKind.Continuous && (limit.Attribute("lower") ?? limit.Attribute("upper")) != null)
            {
                lower = source.Number(limit, "lower", 0);
                upper = source.Number(limit, "upper", 0);
            }
            if (lower > upper) throw source.Error(limit, UrdfMessages.Limits(lower, upper));
            return new JointLimits(
                lower, upper, Bound(source, limit, "velocity"), Bound(source, limit, "effort"), Bound(source, limit, "acceleration"),
                Bound(source, limit, "jerk"));
        }

        // Some exporters write 0 or -1 for an unknown limit. A joint that really cannot move has the type fixed.
        static double Bound(UrdfSource source, XElement limit, string attribute)
        {
            var value = source.Number(limit, attribute, 0);
            return value > 0 ? value : double.PositiveInfinity;
        }

        static JointMimic Mimic(UrdfSource source, XElement element)
        {
            var mimic = UrdfSource.Child(element, "mimic");
            return mimic == null ? null : new JointMimic(
                source.RequiredName(mimic, "joint"), source.Number(mimic, "multiplier", 1), source.Number(mimic, "offset", 0));
        }
    }
}
