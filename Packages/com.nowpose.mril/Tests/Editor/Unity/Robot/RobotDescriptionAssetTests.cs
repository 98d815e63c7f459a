using Nowpose.Tests.Core.Kinematics;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;

namespace Nowpose.Tests.Unity.Robot
{
    public class RobotDescriptionAssetTests
    {
        readonly SceneObjects _scene = new SceneObjects();

        [TearDown]
        public void Clean() => _scene.Destroy();

        RobotDescriptionAsset Asset(string urdf) => _scene.Asset<RobotDescriptionAsset>("My Robot").With("_urdf", urdf);

        [Test]
        public void Read_Urdf_ReturnsTheRobot()
        {
            var asset = Asset(UrdfFiles.Text("ur5.urdf"));

            Assert.That(asset.Read().Name, Is.EqualTo("ur5"));
            Assert.That(asset.Urdf, Is.EqualTo(UrdfFiles.Text("ur5.urdf")));
        }

        [Test]
        public void Create_AtRunTime_ReadsTheSameRobot()
        {
            var asset = RobotDescriptionAsset.Create("Scanned", UrdfFiles.Text("ur5.urdf"));
            try
            {
                Assert.That(asset.name, Is.EqualTo("Scanned"));
                Assert.That(asset.Read().SourceHash, Is.EqualTo(UrdfFiles.Robot("ur5").SourceHash));
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(asset);
            }
        }

        [TestCase("")]
        [TestCase(" \n")]
        [TestCase(null)]
        public void Read_NoText_NamesTheAsset(string text)
        {
            Assert.That(Assert.Throws<InputException>(() => Asset(text).Read()).Message, Is.EqualTo(RigMessages.NoUrdf("My Robot")));
        }

        [Test]
        public void Read_InvalidDescription_NamesTheAssetAndTheLine()
        {
            var fault = Assert.Throws<InputException>(() => Asset("<robot name='r'>\n<joint name='j'/>\n</robot>").Read());

            Assert.That(fault.Message, Does.Contain("'My Robot':2:").And.Contain("'j'"));
        }
    }
}
