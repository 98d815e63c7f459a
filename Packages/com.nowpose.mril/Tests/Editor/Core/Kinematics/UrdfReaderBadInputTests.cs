using Nowpose.Kinematics;
using Nowpose.Messages;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Kinematics
{
    /// <summary>Checks that an invalid URDF is rejected with an error message of one line that states the place and the error.</summary>
    public class UrdfReaderBadInputTests
    {
        const string Links = "<link name='a'/><link name='b'/><link name='c'/>\n";
        const string Ends = "<parent link='a'/><child link='b'/>";

        static readonly string[][] NotRobots =
        {
            new[] { "", "r.urdf:1: " + UrdfMessages.NotWellFormed("") },
            new[] { "not a robot", "r.urdf:1: " + UrdfMessages.NotWellFormed("") },
            new[] { "<robot>\n<link name='a'>\n</robot>", "r.urdf:3: " + UrdfMessages.NotWellFormed("") },
            new[] { "<robot name='r'/><robot name='s'/>", "r.urdf:1: " + UrdfMessages.NotWellFormed("") },
            new[] { "<sdf version='1'>\n<model/></sdf>", "r.urdf:1: sdf: " + UrdfMessages.Root },
            new[] { "<robot name='r'/>", "r.urdf:1: robot 'r': " + UrdfMessages.NoLinks },
            new[]
            {
                "<robot name='$(arg name)' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n<link name='world'/>\n<xacro:arm prefix=''/></robot>",
                "r.urdf:3: arm: " + UrdfMessages.Xacro,
            },
            new[]
            {
                "<robot name='r' xmlns:xacro='http://ros.org/wiki/xacro'><link name='a'>\n<xacro:insert_block name='b'/></link></robot>",
                "r.urdf:2: link 'a' <insert_block>: " + UrdfMessages.Xacro,
            },
            new[] { "<!DOCTYPE r [<!ENTITY a 'b'>]>\n<robot/>", "r.urdf:1: " + UrdfMessages.DocumentType },
            new[] { "<?xml version='1.0'?>\n<!DOCTYPE r SYSTEM 'file:///etc/passwd'>\n<robot/>", "r.urdf:2: " + UrdfMessages.DocumentType },
        };

        [TestCaseSource(nameof(NotRobots))]
        public void Read_NotARobot_NamesTheLine(string text, string message) => Refuses(text, message);

        static readonly string[][] InvalidLinks =
        {
            new[] { "<link/>", "r.urdf:2: link: " + UrdfMessages.AttributeMissing("name") },
            new[] { "<link name='a'/>\n<link name='a'/>", "r.urdf:3: link 'a': " + UrdfMessages.LinkTwice },
            new[] { "<link name='a'/>\n<link name='b'/>", "r.urdf:3: link 'b': " + UrdfMessages.TwoRoots("'a'") },
            new[]
            {
                "<link name='a'><visual><geometry><box size='1 2'/></geometry></visual></link>",
                "link 'a' <box>: " + UrdfMessages.NotATriple("size", 2),
            },
            new[]
            {
                "<link name='a'><visual><geometry><sphere/></geometry></visual></link>",
                "link 'a' <sphere>: " + UrdfMessages.AttributeMissing("radius"),
            },
            new[]
            {
                "<link name='a'><visual><geometry><cylinder radius='1' length='-1'/></geometry></visual></link>",
                "link 'a' <cylinder>: " + UrdfMessages.Length("length", -1),
            },
            new[]
            {
                "<link name='a'><visual><geometry><mesh/></geometry></visual></link>",
                "link 'a' <mesh>: " + UrdfMessages.AttributeMissing("filename"),
            },
            new[]
            {
                "<material name='m'>\n<color rgba='1 0'/></material><link name='a'/>",
                "r.urdf:3: material 'm' <color>: " + UrdfMessages.Colour(2),
            },
        };

        [TestCaseSource(nameof(InvalidLinks))]
        public void Read_InvalidLink_NamesTheElement(string body, string message) => Refuses("<robot name='r'>\n" + body + "</robot>", message);

        static readonly string[][] InvalidJoints =
        {
            new[] { "<joint type='fixed'>" + Ends + "</joint>", "r.urdf:3: joint: " + UrdfMessages.AttributeMissing("name") },
            new[] { "<joint name='j'>" + Ends + "</joint>", "r.urdf:3: joint 'j': " + UrdfMessages.AttributeMissing("type") },
            new[] { "<joint name='j' type='planar'>" + Ends + "</joint>", "r.urdf:3: joint 'j': " + UrdfMessages.JointType("'planar'") },
            new[] { "<joint name='j' type='floating'>" + Ends + "</joint>", "joint 'j': " + UrdfMessages.JointType("'floating'") },
            new[] { "<joint name='j' type='screw'>" + Ends + "</joint>", "joint 'j': " + UrdfMessages.JointType("'screw'") },
            new[] { "<joint name='j' type='fixed'><child link='b'/></joint>", "joint 'j': " + UrdfMessages.LinkMissing("parent") },
            new[]
            {
                "<joint name='j' type='fixed'><parent link='a'/><child/></joint>",
                "joint 'j' <child>: " + UrdfMessages.AttributeMissing("link"),
            },
            new[]
            {
                "<joint name='j' type='fixed'>\n<parent link='a'/>\n<child link='z'/></joint>",
                "r.urdf:5: joint 'j' <child>: " + UrdfMessages.UnknownLink("'z'"),
            },
            new[]
            {
                "<joint name='j' type='fixed'>\n<parent link='z'/><child link='a'/></joint>",
                "r.urdf:4: joint 'j' <parent>: " + UrdfMessages.UnknownLink("'z'"),
            },
            new[]
            {
                "<joint name='j' type='fixed'>" + Ends + "</joint>\n<joint name='j' type='fixed'><parent link='a'/><child link='c'/></joint>",
                "r.urdf:4: joint 'j': " + UrdfMessages.JointTwice,
            },
        };

        [TestCaseSource(nameof(InvalidJoints))]
        public void Read_InvalidJoint_NamesTheJoint(string joints, string message) => RefusesJoints(joints, message);

        static readonly string[][] InvalidJointContents =
        {
            new[] { "<axis xyz='0 0 0'/>", "<axis>: " + UrdfMessages.Axis },
            new[] { "<axis xyz='0 1'/>", "<axis>: " + UrdfMessages.NotATriple("xyz", 2) },
            new[] { "<origin xyz='0 0 0 0'/>", "<origin>: " + UrdfMessages.NotATriple("xyz", 4) },
            new[] { "<origin xyz=''/>", "<origin>: " + UrdfMessages.NotATriple("xyz", 0) },
            new[] { "<origin rpy='0 x 0'/>", "<origin>: " + UrdfMessages.NotANumber("rpy", "'x'", isXacro: false) },
            new[] { "<origin rpy='0 NaN 0'/>", "<origin>: " + UrdfMessages.NotANumber("rpy", "'NaN'", isXacro: false) },
            new[] { "<origin xyz='0 1e999 0'/>", "<origin>: " + UrdfMessages.NotANumber("xyz", "'1e999'", isXacro: false) },
            new[] { "<origin xyz='0,5 0 0'/>", "<origin>: " + UrdfMessages.NotANumber("xyz", "'0,5'", isXacro: false) },
            new[] { "<origin xyz='${pi} 0 0'/>", "<origin>: " + UrdfMessages.NotANumber("xyz", "'${pi}'", isXacro: true) },
            new[] { "<limit lower='1' upper='-1'/>", "<limit>: " + UrdfMessages.Limits(1, -1) },
            new[] { "<limit lower='1'/>", "<limit>: " + UrdfMessages.Limits(1, 0) },
            new[] { "<limit upper='Infinity'/>", "<limit>: " + UrdfMessages.NotANumber("upper", "'Infinity'", isXacro: false) },
            new[] { "<limit velocity='fast'/>", "<limit>: " + UrdfMessages.NotANumber("velocity", "'fast'", isXacro: false) },
            new[] { "<mimic/>", "<mimic>: " + UrdfMessages.AttributeMissing("joint") },
            new[] { "<mimic joint='z'/>", "<mimic>: " + UrdfMessages.UnknownJoint("'z'") },
            new[] { "<mimic joint='j'/>", "<mimic>: " + UrdfMessages.MimicCycle("'j'") },
            new[] { "<mimic joint='k'/>", "<mimic>: " + UrdfMessages.MimicOfFixed("'k'") },
            new[] { "<mimic joint='m' multiplier='two'/>", "<mimic>: " + UrdfMessages.NotANumber("multiplier", "'two'", isXacro: false) },
        };

        [TestCaseSource(nameof(InvalidJointContents))]
        public void Read_InvalidJointContent_NamesTheElement(string inside, string message) => RefusesJoints(
            "<joint name='j' type='revolute'>" + Ends + "\n" + inside + "</joint>"
            + "<joint name='k' type='fixed'><parent link='b'/><child link='c'/></joint>", "r.urdf:4: joint 'j' " + message);

        [Test]
        public void Read_MimicCycle_NamesAJointOfTheCycle() => RefusesJoints(
            Joint("i", "a", "b", "<mimic joint='j'/>") + "\n" + Joint("j", "b", "c", "<mimic joint='k'/>") + "\n"
            + "<link name='d'/>" + Joint("k", "c", "d", "<mimic joint='j'/>"),
            "r.urdf:4: joint 'j' <mimic>: " + UrdfMessages.MimicCycle("'k'"));

        [Test]
        public void Read_LinkWithTwoParents_NamesTheLink() => RefusesJoints(
            Joint("i", "a", "c") + "\n" + Joint("j", "b", "c"),
            "r.urdf:4: joint 'j': " + UrdfMessages.TwoParents("'c'", "'i'"));

        [Test]
        public void Read_CycleOfAllLinks_NamesTheCycle() => RefusesJoints(
            Joint("i", "a", "b") + Joint("j", "b", "c") + Joint("k", "c", "a"), UrdfMessages.Cycle("'a'"));

        [Test]
        public void Read_CycleBesideARoot_NamesALinkOfTheCycle() => RefusesJoints(
            Joint("j", "b", "c") + "\n" + Joint("k", "c", "b"), "r.urdf:4: joint 'k': " + UrdfMessages.Cycle("'b'"));

        [Test]
        public void Read_LinkJoinedToItself_IsRefusedAsACycle() => RefusesJoints(
            Joint("i", "a", "b") + Joint("j", "c", "c"), "joint 'j': " + UrdfMessages.Cycle("'c'"));

        [Test]
        public void Read_LongNameWithLineBreak_IsShownInOneShortLine()
        {
            var name = "x&#10;y" + new string('z', 1000);
            var error = Assert.Throws<InputException>(() => UrdfReader.Read("<robot><link name='" + name + "'/><link name='b'/></robot>", "r.urdf"));

            Assert.That(error.Message, Does.Not.Contain("\n"));
            Assert.That(error.Message.Length, Is.LessThan(250));
        }

        [Test]
        public void Read_DeeplyNestedElements_AreRefused() => Refuses(
            "<robot name='r'><link name='a'/>\n<gazebo>" + string.Concat(System.Linq.Enumerable.Repeat("<x>", 100000)),
            UrdfMessages.TooDeep("r.urdf", 2, 100));

        [Test]
        public void Read_NestedEntities_AreRefusedWithoutExpansion() => Refuses(
            "<!DOCTYPE r [<!ENTITY a '0000000000'><!ENTITY b '&a;&a;&a;&a;&a;&a;&a;&a;'><!ENTITY c '&b;&b;&b;&b;&b;&b;&b;&b;'>]>"
            + "<robot name='&c;'><link name='a'/></robot>", "r.urdf:1: " + UrdfMessages.DocumentType);

        static string Joint(string name, string parent, string child, string inside = "") =>
            UrdfFiles.Joint(name, parent, child, "revolute", inside);

        // Line 2 contains three links; the joints begin on line 3.
        static void RefusesJoints(string joints, string message) => Refuses("<robot name='r'>\n" + Links + joints + "</robot>", message);

        static void Refuses(string text, string message)
        {
            var error = Assert.Throws<InputException>(() => UrdfReader.Read(text, "r.urdf"));

            Assert.That(error.Message, Does.StartWith("r.urdf:").And.Contains(message));
            Assert.That(error.Message, Does.Not.Contain("\n"));
        }
    }
}
