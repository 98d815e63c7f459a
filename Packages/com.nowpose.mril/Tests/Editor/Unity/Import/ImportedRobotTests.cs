using Nowpose.Kinematics;
using Nowpose.Tests.Unity.Robot;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using Random = System.Random;

namespace Nowpose.Tests.Unity.Import
{
    /// <summary>Tests robots of the package and of the tests as the Editor imports them from .urdf files.</summary>
    public class ImportedRobotTests
    {
        const string Robots = "Packages/com.nowpose.mril/Runtime/Robots/";
        const string OddAxes = "Packages/com.nowpose.mril/Tests/Editor/Core/Kinematics/odd_axes.urdf";

        [TestCase(Robots + "youbot.urdf")]
        [TestCase(Robots + "ur5.urdf")]
        [TestCase(OddAxes)]
        public void Prefab_ImportedRobot_MatchesForwardKinematics(string path)
        {
            var model = AssetDatabase.LoadAssetAtPath<RobotDescriptionAsset>(path).Read();
            var robot = Object.Instantiate(AssetDatabase.LoadAssetAtPath<GameObject>(path));
            try
            {
                var rig = robot.GetComponent<RobotRig>();
                var before = robot.GetComponentsInChildren<Transform>(true).Length;
                rig.Bind(model);
                for (var seed = 1; seed <= 20; seed++)
                {
                    var positions = RobotPoses.Any(model, new Random(seed));

                    rig.Apply(positions);

                    RobotPoses.RequireAgreement(rig, positions, path + ", seed " + seed);
                }
                Assert.That(robot.GetComponentsInChildren<Transform>(true).Length, Is.EqualTo(before), "the rig built no second robot");
            }
            finally
            {
                Object.DestroyImmediate(robot);
            }
        }

        [TestCase(Robots + "youbot.urdf")]
        [TestCase(Robots + "ur5.urdf")]
        public void Prefab_ImportedRobot_ShowsEveryVisual(string path)
        {
            var visuals = 0;
            foreach (var link in AssetDatabase.LoadAssetAtPath<RobotDescriptionAsset>(path).Read().Links) visuals += link.Visuals.Count;

            var renderers = AssetDatabase.LoadAssetAtPath<GameObject>(path).GetComponentsInChildren<Renderer>(true);

            Assert.That(visuals, Is.GreaterThan(5));
            Assert.That(renderers.Length, Is.EqualTo(visuals));
            foreach (var renderer in renderers) Assert.That(renderer.sharedMaterial.shader.name, Is.EqualTo("Nowpose/Hologram"));
        }
    }
}
