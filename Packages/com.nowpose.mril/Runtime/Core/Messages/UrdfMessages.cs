using System;

namespace Nowpose.Messages
{
    /// <summary>Error messages about a robot description. The reader adds the file, the line and the element.</summary>
    static class UrdfMessages
    {
        public const string JointTwice = "another joint has the same name; rename one of them";

        public static string JointType(string type) => $"type {type} is not supported; allowed: fixed, revolute, continuous and prismatic";

        public const string Axis = "xyz is not a direction; a moving joint needs a vector other than 0 0 0";

        public static string Limits(double lower, double upper) =>
            FormattableString.Invariant($"lower {lower} is above upper {upper}; swap or correct them");

        public static string BoxSize(double x, double y, double z) =>
            FormattableString.Invariant($"size is {x} {y} {z} m; it must be 3 lengths of at least 0 m");

        public static string Length(string attribute, double metres) =>
            FormattableString.Invariant($"{attribute} is {metres} m; it must be a length of at least 0 m");
        public static string Colour(int count) => $"rgba has {count} numbers; it needs 4";

        public static string MimicCycle(string master) =>
            $"the chain of mimicked joints through {master} leads back to this joint; remove one <mimic> element";

        public static string MimicOfFixed(string joint) => $"joint {joint} is fixed; only a moving joint can be mimicked; remove the <mimic> element";

        public static string LinkMissing(string role) => $"its <{role} link=…/> is missing; add it";
        public static string UnknownJoint(string joint) => $"unknown joint {joint}; correct the name";
        public static string UnknownLink(string link) => $"unknown link {link}; correct the name";

        public const string Xacro = "this is an element of xacro; expand the file with xacro first";
        public const string Root = "the root element must be <robot>";

        public static string AttributeMissing(string attribute) => $"its attribute {attribute} is missing or empty; add it";
        public static string NotATriple(string attribute, int count) => $"{attribute} has {count} numbers; it needs 3";

        public static string TooDeep(string file, int line, int max) =>
            $"{file}:{line}: elements are nested more than {max} levels deep; check that it is a URDF";

        public static string NotWellFormed(string reason) => $"not well-formed XML: {reason}";

        public const string DocumentType = "a document type (DTD) with its entities is not allowed in a URDF; remove it";
        public const string NoLinks = "the robot has no links; it needs at least one <link>";
        public const string LinkTwice = "another link has the same name; rename one of them";

        public static string TwoParents(string link, string joint) =>
            $"link {link} is already the child of joint {joint}; a link must have at most one parent; remove one of the joints";

        public static string TwoRoots(string other) =>
            $"there are two root links, this one and {other}; every link except one must be the child of a joint";

        public static string Cycle(string link) =>
            $"link {link} is its own ancestor: the joints form a cycle; correct the parent or child of one of them";

        /// <param name="isXacro">Whether the value is a xacro expression.</param>
        public static string NotANumber(string attribute, string text, bool isXacro) => isXacro
            ? $"{attribute} {text} is not a finite number; expand the file with xacro first"
            : $"{attribute} {text} is not a finite number; correct it";
    }
}
