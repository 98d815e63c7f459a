using System;
using System.Collections.Generic;
using System.Linq;
using Newtonsoft.Json.Linq;
using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Kinematics
{
    public class ForwardKinematicsTests
    {
        const double Tolerance = 1e-9;

        // Denavit-Hartenberg parameters that Universal Robots publishes: d1, a2, a3, d4, d5, d6 in metres.
        static readonly Dictionary<string, double[]> DenavitHartenbergOf = new Dictionary<string, double[]>
        {
            ["ur5"] = new[] { 0.089159, -0.425, -0.39225, 0.10915, 0.09465, 0.0823 },
            ["ur3e"] = new[] { 0.15185, -0.24355, -0.2132, 0.13105, 0.08535, 0.0921 },
            ["ur5e"] = new[] { 0.1625, -0.425, -0.3922, 0.1333, 0.0997, 0.0996 },
            ["ur10e"] = new[] { 0.1807, -0.6127, -0.57155, 0.17415, 0.11985, 0.11655 },
            ["ur16e"] = new[] { 0.1807, -0.4784, -0.36, 0.17415, 0.11985, 0.11655 },
        };

        // Reference poses computed by urdf-loader and three.js; Tests/Package/make-reference.mjs wrote them.
        [TestCase("youbot")]
        [TestCase("ur5")]
        [TestCase("odd_axes")]
        public void Compute_AnyPositions_AgreesWithAnotherLibrary(string name)
        {
            var model = UrdfFiles.Robot(name);
            var reference = JObject.Parse(UrdfFiles.Text("reference_poses.json"))["robots"].Single(r => (string)r["robot"] == name);

            Assert.That(reference["cases"], Is.Not.Empty);
            foreach (var situation in reference["cases"])
            {
                var poses = Poses(model, (JObject)situation["joints"]);

                Assert.That(situation["links"].Count(), Is.EqualTo(model.Links.Count));
                foreach (var link in (JObject)situation["links"])
                    Assert.That(
                        poses[model.IndexOfLink(link.Key)].ToRowMajor16(),
                        Is.EqualTo(link.Value.Select(v => (double)v).ToArray()).Within(Tolerance), link.Key);
            }
        }

        [TestCase("ur5")]
        [TestCase("ur3e")]
        [TestCase("ur5e")]
        [TestCase("ur10e")]
        [TestCase("ur16e")]
        public void Compute_UniversalRobot_EqualsTheProductOfItsDenavitHartenbergMatrices(string name)
        {
            var model = UrdfFiles.Robot(name);
            var poses = new RigidTransform[model.Links.Count];
            var random = new Random(5);

            for (var i = 0; i < 50; i++)
            {
                var q = Enumerable.Range(0, 6).Select(_ => (2 * random.NextDouble() - 1) * 3 * Math.PI).ToArray();
                new ForwardKinematics(model).Compute(q, poses);
                Assert.That(
                    poses[model.IndexOfLink("tool0")].ToRowMajor16(),
                    Is.EqualTo(DenavitHartenberg(DenavitHartenbergOf[name], q).ToRowMajor16()).Within(1e-12));
            }
        }

        [Test]
        public void Compute_QuarterTurnAboutZ_RotatesXToY()
        {
            var model = UrdfFiles.Read(UrdfFiles.Links("a", "b", "c")
                + UrdfFiles.Joint("turn", "a", "b", inside: "<origin xyz='1 2 3'/><axis xyz='0 0 9'/>")
                + UrdfFiles.Joint("slide", "b", "c", "prismatic", "<axis xyz='2 0 0'/>"));
            var poses = new RigidTransform[3];

            new ForwardKinematics(model).Compute(new[] { Math.PI / 2, 0.5 }, poses);

            Assert.That(poses[2].ToRowMajor16(), Is.EqualTo(new[]
            {
                0.0, -1, 0, 1,
                1, 0, 0, 2.5,
                0, 0, 1, 3,
                0, 0, 0, 1,
            }).Within(1e-15));
        }

        [Test]
        public void Compute_WrongLengths_Throws()
        {
            var kinematics = new ForwardKinematics(UrdfFiles.Robot("ur5"));

            Assert.Throws<ArgumentException>(() => kinematics.Compute(new double[5], new RigidTransform[8]));
            Assert.Throws<ArgumentException>(() => kinematics.Compute(new double[6], new RigidTransform[7]));
        }

        static RigidTransform[] Poses(RobotModel model, JObject joints)
        {
            var positions = new double[model.MovingJoints.Count];
            var given = new bool[positions.Length];
            foreach (var joint in joints)
            {
                var index = model.IndexOfMovingJoint(joint.Key);
                positions[index] = (double)joint.Value;
                given[index] = true;
            }
            model.CompleteMimics(positions, given);
            var poses = new RigidTransform[model.Links.Count];
            new ForwardKinematics(model).Compute(positions, poses);
            return poses;
        }

        static RigidTransform DenavitHartenberg(double[] parameters, double[] q)
        {
            double[] d = { parameters[0], 0, 0, parameters[3], parameters[4], parameters[5] };
            double[] a = { 0, parameters[1], parameters[2], 0, 0, 0 };
            double[] alpha = { Math.PI / 2, 0, 0, Math.PI / 2, -Math.PI / 2, 0 };
            var product = RigidTransform.Identity;
            for (var i = 0; i < q.Length; i++)
                product = product * RigidTransform.FromXyzRpy(0, 0, d[i], 0, 0, q[i]) * RigidTransform.FromXyzRpy(a[i], 0, 0, alpha[i], 0, 0);
            return product;
        }
    }
}
