using System.Linq;
using Newtonsoft.Json.Linq;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Prediction;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Tests.Core.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Frames
{
    /// <summary>Compares poses in chains of moving frames, links and stationary frames with poses computed by another library.</summary>
    /// <remarks>
    /// Orocos KDL computed the numbers of <c>frame_reference_poses.json</c>; <c>Tests/Package/make-frame-reference.py</c> wrote them and describes
    /// the cell. Tracked frames move at constant rates, which <c>linear</c> predicts exactly.
    /// </remarks>
    public class FrameReferenceTests
    {
        /// <summary>Rounding error of the prediction over 130 ms and of the product of five poses, m.</summary>
        const double Tolerance = 1e-10;

        static readonly JObject Reference = JObject.Parse(UrdfFiles.Text("../Frames/frame_reference_poses.json"));

        [Test]
        public void World_PartInAGripperOnAVehiclesArm_AgreesWithAnotherLibrary([Range(0, 5)] int number)
        {
            var given = (JObject)Reference["cases"][number];
            var tree = new FrameTree(() => new BodyPredictor("linear", new PredictionLimits()));
            tree.Add(ArmAt((JObject)given["joints"]));
            foreach (var frame in given["stationary"]) Add(tree, frame, 0, frame["pose"].ToObject<double[]>(), isStationary: true);
            foreach (var frame in given["tracked"])
                foreach (var sample in frame["samples"].Select(one => one.ToObject<double[]>()))
                    Add(tree, frame, sample[0], sample.Skip(1).ToArray(), isStationary: false);

            tree.Evaluate(At((double)Reference["display_s"]));

            Assert.That(given["world"], Is.Not.Empty);
            foreach (var expected in (JObject)given["world"])
            {
                var frame = tree[tree.IndexOf(expected.Key)];
                Assert.That(frame.State, Is.EqualTo(FrameState.Current), expected.Key);
                Assert.That(frame.World.ToRowMajor16(), Is.EqualTo(expected.Value.ToObject<double[]>()).Within(Tolerance), expected.Key);
            }
        }

        static MovingLinks ArmAt(JObject joints)
        {
            var model = UrdfFiles.Robot((string)Reference["robot"]);
            var positions = new double[model.MovingJoints.Count];
            foreach (var joint in joints) positions[model.IndexOfMovingJoint(joint.Key)] = (double)joint.Value;
            var poses = new RigidTransform[model.Links.Count];
            new ForwardKinematics(model).Compute(positions, poses);
            var arm = new MovingLinks("arm", model);
            for (var link = 0; link < poses.Length; link++) arm.Move(link, poses[link]);
            return arm;
        }

        static void Add(FrameTree tree, JToken frame, double t, double[] p, bool isStationary) => Assert.That(
            tree.Add(new FrameTransform(At(t), (string)frame["parent"], (string)frame["child"], p[0], p[1], p[2], p[3], p[4], p[5], p[6]), isStationary),
            Is.EqualTo(DropReason.None));

        static ControlTime At(double seconds) => ControlTime.FromSeconds(1000 + seconds);
    }
}
