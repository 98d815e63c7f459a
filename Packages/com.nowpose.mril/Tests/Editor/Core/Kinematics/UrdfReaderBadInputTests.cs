using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Kinematics
{
    /// <summary>Checks that an invalid URDF is rejected with an error message of one line that states the place and the error.</summary>
    public class UrdfReaderBadInputTests
    {
        const string Links = "<link name='a'/><link name='b'/><link name='c'/>\n";
        const string Ends = "<parent link='a'/><child link='b'/>";

        [TestCase("", "r.urdf:1: not well-formed XML")]
        [TestCase("not a robot", "r.urdf:1: not well-formed XML")]
        [TestCase("<robot>\n<link name='a'>\n</robot>", "r.urdf:3: not well-formed XML")]
        [TestCase("<robot name='r'/><robot name='s'/>", "r.urdf:1: not well-formed XML")]
        [TestCase("<sdf version='1'>\n<model/></sdf>", "r.urdf:1: sdf: the root element must be <robot>")]
        [TestCase("<robot name='r'/>", "r.urdf:1: robot 'r': the robot has no links")]
        [TestCase("<!DOCTYPE r [<!ENTITY a 'b'>]>\n<robot/>", "r.urdf:1: a document type (DTD)")]
        [TestCase("<?xml version='1.0'?>\n<!DOCTYPE r SYSTEM 'file:///etc/passwd'>\n<robot/>", "r.urdf:2: a document type (DTD)")]
        public void Read_NotARobot_NamesTheLine(string text, string message) => Refuses(text, message);

        [TestCase("<link/>", "r.urdf:2: link: its attribute name is missing")]
        [TestCase("<link name='a'/>\n<link name='a'/>", "r.urdf:3: link 'a': another link has the same name")]
        [TestCase("<link name='a'/>\n<link name='b'/>", "r.urdf:3: link 'b': there are two root links, this one and 'a'")]
        [TestCase("<link name='a'><visual><geometry><box size='1 2'/></geometry></visual></link>", "link 'a' <box>: size has 2 numbers")]
        [TestCase("<link name='a'><visual><geometry><sphere/></geometry></visual></link>", "link 'a' <sphere>: its attribute radius is missing")]
        [TestCase("<link name='a'><visual><geometry><cylinder radius='1' length='-1'/></geometry></visual></link>", "link 'a' <cylinder>: length is -1 m; it must be a length of at least 0 m")]
        [TestCase("<link name='a'><visual><geometry><mesh/></geometry></visual></link>", "link 'a' <mesh>: its attribute filename is missing")]
        [TestCase("<material name='m'>\n<color rgba='1 0'/></material><link name='a'/>", "r.urdf:3: material 'm' <color>: rgba has 2 numbers")]
        public void Read_InvalidLink_NamesTheElement(string body, string message) => Refuses("<robot name='r'>\n" + body + "</robot>", message);

        [TestCase("<joint type='fixed'>" + Ends + "</joint>", "r.urdf:3: joint: its attribute name is missing")]
        [TestCase("<joint name='j'>" + Ends + "</joint>", "r.urdf:3: joint 'j': its attribute type is missing")]
        [TestCase("<joint name='j' type='planar'>" + Ends + "</joint>", "r.urdf:3: joint 'j': type 'planar' is not supported; allowed: fixed, revolute, continuous and prismatic")]
        [TestCase("<joint name='j' type='floating'>" + Ends + "</joint>", "joint 'j': type 'floating' is not supported")]
        [TestCase("<joint name='j' type='screw'>" + Ends + "</joint>", "joint 'j': type 'screw' is not supported")]
        [TestCase("<joint name='j' type='fixed'><child link='b'/></joint>", "joint 'j': its <parent link=…/> is missing")]
        [TestCase("<joint name='j' type='fixed'><parent link='a'/><child/></joint>", "joint 'j' <child>: its attribute link is missing")]
        [TestCase(
            "<joint name='j' type='fixed'>\n<parent link='a'/>\n<child link='z'/></joint>", "r.urdf:5: joint 'j' <child>: unknown link 'z'")]
        [TestCase("<joint name='j' type='fixed'>\n<parent link='z'/><child link='a'/></joint>", "r.urdf:4: joint 'j' <parent>: unknown link 'z'")]
        [TestCase("<joint name='j' type='fixed'>" + Ends + "</joint>\n<joint name='j' type='fixed'><parent link='a'/><child link='c'/></joint>", "r.urdf:4: joint 'j': another joint has the same name")]
        public void Read_InvalidJoint_NamesTheJoint(string joints, string message) => RefusesJoints(joints, message);

        [TestCase("<axis xyz='0 0 0'/>", "<axis>: xyz is not a direction")]
        [TestCase("<axis xyz='0 1'/>", "<axis>: xyz has 2 numbers; it needs 3")]
        [TestCase("<origin xyz='0 0 0 0'/>", "<origin>: xyz has 4 numbers; it needs 3")]
        [TestCase("<origin xyz=''/>", "<origin>: xyz has 0 numbers; it needs 3")]
        [TestCase("<origin rpy='0 x 0'/>", "<origin>: rpy 'x' is not a finite number")]
        [TestCase("<origin rpy='0 NaN 0'/>", "<origin>: rpy 'NaN' is not a finite number")]
        [TestCase("<origin xyz='0 1e999 0'/>", "<origin>: xyz '1e999' is not a finite number")]
        [TestCase("<origin xyz='0,5 0 0'/>", "<origin>: xyz '0,5' is not a finite number")]
        [TestCase("<origin xyz='${pi} 0 0'/>", "<origin>: xyz '${pi}' is not a finite number; expand the file with xacro first")]
        [TestCase("<limit lower='1' upper='-1'/>", "<limit>: lower 1 is above upper -1")]
        [TestCase("<limit lower='1'/>", "<limit>: lower 1 is above upper 0")]
        [TestCase("<limit upper='Infinity'/>", "<limit>: upper 'Infinity' is not a finite number")]
        [TestCase("<limit velocity='fast'/>", "<limit>: velocity 'fast' is not a finite number")]
        [TestCase("<mimic/>", "<mimic>: its attribute joint is missing")]
        [TestCase("<mimic joint='z'/>", "<mimic>: unknown joint 'z'")]
        [TestCase("<mimic joint='j'/>", "<mimic>: the chain of mimicked joints through 'j' leads back to this joint")]
        [TestCase("<mimic joint='k'/>", "<mimic>: joint 'k' is fixed; only a moving joint can be mimicked")]
        [TestCase("<mimic joint='m' multiplier='two'/>", "<mimic>: multiplier 'two' is not a finite number")]
        public void Read_InvalidJointContent_NamesTheElement(string inside, string message) => RefusesJoints(
            "<joint name='j' type='revolute'>" + Ends + "\n" + inside + "</joint>"
            + "<joint name='k' type='fixed'><parent link='b'/><child link='c'/></joint>", "r.urdf:4: joint 'j' " + message);

        [Test]
        public void Read_MimicCycle_NamesAJointOfTheCycle() => RefusesJoints(
            Joint("i", "a", "b", "<mimic joint='j'/>") + "\n" + Joint("j", "b", "c", "<mimic joint='k'/>") + "\n"
            + "<link name='d'/>" + Joint("k", "c", "d", "<mimic joint='j'/>"),
            "r.urdf:4: joint 'j' <mimic>: the chain of mimicked joints through 'k' leads back to this joint");

        [Test]
        public void Read_LinkWithTwoParents_NamesTheLink() => RefusesJoints(
            Joint("i", "a", "c") + "\n" + Joint("j", "b", "c"),
            "r.urdf:4: joint 'j': link 'c' is already the child of joint 'i'; a link must have at most one parent; remove one of the joints");

        [Test]
        public void Read_CycleOfAllLinks_NamesTheCycle() => RefusesJoints(
            Joint("i", "a", "b") + Joint("j", "b", "c") + Joint("k", "c", "a"), "is its own ancestor: the joints form a cycle");

        [Test]
        public void Read_CycleBesideARoot_NamesALinkOfTheCycle() => RefusesJoints(
            Joint("j", "b", "c") + "\n" + Joint("k", "c", "b"), "r.urdf:4: joint 'k': link 'b' is its own ancestor: the joints form a cycle");

        [Test]
        public void Read_LinkJoinedToItself_IsRefusedAsACycle() => RefusesJoints(
            Joint("i", "a", "b") + Joint("j", "c", "c"), "joint 'j': link 'c' is its own ancestor");

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
            "r.urdf:2: elements are nested more than 100 levels deep");

        [Test]
        public void Read_NestedEntities_AreRefusedWithoutExpansion() => Refuses(
            "<!DOCTYPE r [<!ENTITY a '0000000000'><!ENTITY b '&a;&a;&a;&a;&a;&a;&a;&a;'><!ENTITY c '&b;&b;&b;&b;&b;&b;&b;&b;'>]>"
            + "<robot name='&c;'><link name='a'/></robot>", "r.urdf:1: a document type (DTD) with its entities is not allowed");

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
