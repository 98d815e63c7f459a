using System.Reflection;
using Nowpose.Kinematics;
using Nowpose.Prefabs;
using Nowpose.Samples;
using Nowpose.Unity;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Serialization;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Tests.Assets;

/// <summary>Tests the assets in Unity's text format in the package, in its samples and in the host project.</summary>
public sealed class PackageAssetsTests
{
    const string Runtime = "Packages/com.nowpose.mril/Runtime/";

    /// <summary>
    /// References that may be empty because the component has a fallback, each with the end of the object paths where this is allowed.
    /// </summary>
    static readonly (string Field, string Path)[] MayBeEmpty =
    {
        ("VirtualGripper._rig", "Virtual Gripper"),
        ("RobotRig._description", ""),
        ("HandPlacedMarker._anchor", ""),
        ("PoseAppearance._session", "Virtual Gripper.prefab/Virtual Gripper"),
        // The session above the objects.
        ("RobotRig._session", "Nowpose Robot.prefab/Nowpose Robot/Robot"),
        ("RobotRig._session", "Nowpose Robot.prefab/Nowpose Robot/Ghost"),
        ("PoseAppearance._session", "Nowpose Robot.prefab/Nowpose Robot/Robot"),
        ("PoseAppearance._session", "Nowpose Robot.prefab/Nowpose Robot/Ghost"),
        ("PoseAppearance._words", "/Nowpose Robot/Ghost"),
        ("PoseAppearance._words", "/Second Robot/Ghost"),
        ("PoseAppearance._words", "/Base Anchor/Ghost"),
        ("PoseAppearance._words", "/Cell Objects/"),
        ("BodyFollow._head", "/Status Panel"),
        ("StatusPanel._bar", "/Status Panel"),
        ("BodyFollow._head", "/Calibration"),
        ("BodyFollow._head", "/Status Panel (MRTK3)"),
        ("BodyFollow._head", "/Content"),
        ("GraspableMarker._bounds", "/Hand-Placed Marker"),
        // References to objects outside of the prefab, which the scene of the sample assigns.
        ("StatusPanel._session", "Status Panel (MRTK3).prefab/Status Panel (MRTK3)"),
        ("CellActions._pairing", "Headset Menu.prefab/Headset Menu"),
        // This scene does not detect codes.
        ("CellActions._pairing", "Any OpenXR headset.unity/Nowpose Robot Cell"),
        ("ConsentPrompt._pairing", "Consent Prompt.prefab/Consent Prompt"),
        ("CellActions._session", "Headset Menu.prefab/Headset Menu"),
        ("CellActions._anchor", "Headset Menu.prefab/Headset Menu"),
        ("CellActions._ghost", "Headset Menu.prefab/Headset Menu"),
        ("CellActions._appearance", "Headset Menu.prefab/Headset Menu"),
        ("CellActions._panel", "Headset Menu.prefab/Headset Menu"),
        ("CellActions._occluder", "Headset Menu.prefab/Headset Menu"),
        ("LatencyProfileLoader._shipped", ""),
    };

    AssetLibrary _library;

    static IEnumerable<string> Assets => RepositoryFiles.All
        .Where(f => Path.GetExtension(f) is ".prefab" or ".unity" or ".asset" or ".mat")
        .Where(f => !f.StartsWith("ProjectSettings/", StringComparison.Ordinal));

    /// <summary>All assets except the stand-ins for prefabs of other packages, whose fileIDs come from these packages.</summary>
    static IEnumerable<string> OwnAssets => Assets.Where(f => !f.StartsWith("Headless/", StringComparison.Ordinal));

    static IEnumerable<string> Hierarchies => OwnAssets.Where(f => Path.GetExtension(f) is ".prefab" or ".unity");

    [SetUp]
    public void SetUp() => _library = RepositoryAssets.NewLibrary();

    [Test]
    public void Assets_InTheRepository_MatchTheOutputOfTheTool()
    {
        // The tool creates its objects in this world.
        using var scene = new World(isPlaying: false, (_, _, _, _) => { }).Enter();

        Assert.That(AssetPlan.Differing(RepositoryFiles.Root), Is.Empty, "run: dotnet run --project Headless/Tools/Prefabs");
        Assert.That(OwnAssets.Where(f => Path.GetExtension(f) != ".mat"), Is.EquivalentTo(AssetPlan.Paths));
    }

    [TestCaseSource(nameof(OwnAssets))]
    public void Asset_LoadedAndWritten_HasTheSameText(string path)
    {
        var writer = new AssetWriter(_library);

        var written = Path.GetExtension(path) switch
        {
            ".unity" => _library.LoadScene(path) is var scene ? writer.Scene(scene.Roots, scene.Settings) : null,
            ".prefab" => writer.Prefab(_library.Load<GameObject>(path)),
            ".mat" => writer.Asset(_library.Load<Material>(path)),
            _ => writer.Asset(_library.Load<ScriptableObject>(path)),
        };

        Assert.That(written, Is.EqualTo(RepositoryFiles.Read(path)));
    }

    [TestCaseSource(nameof(Hierarchies))]
    public void Hierarchy_RequiredReferences_AreSet(string path)
    {
        var isScene = Path.GetExtension(path) == ".unity";
        var roots = isScene ? _library.LoadScene(path).Roots : new[] { _library.Load<GameObject>(path) };
        var components = roots.SelectMany(r => r.GetComponentsInChildren<Component>(true));

        var empty = components.SelectMany(c => SerializedFields.Of(c.GetType()).SelectMany(f => Empty(f, c))
            .Select(f => (Field: c.GetType().Name + "." + f, Path: path + PathOf(c.transform))));

        // In one scene the gateway describes the robot. In two others the simulation moves rigs, which therefore have no session.
        string[] left = path.Contains("Any Robot") ? ["MrilSession._robot"]
            : path.EndsWith("Virtual Robot Cell.unity", StringComparison.Ordinal) ? ["RobotRig._session"]
            : IsOfTwoArms(path) ? ["RobotRig._session", "RobotRig._session"] : [];
        var missing = empty.Where(e => !MayBeEmpty.Any(m => m.Field == e.Field && IsIn(m.Path, e.Path)));
        Assert.That(missing.Select(e => e.Field), Is.EquivalentTo(left), string.Join("\n", missing));
    }

    /// <summary>Returns whether a path ends with the place. A place that ends with a slash includes all objects below it.</summary>
    static bool IsIn(string place, string path) =>
        place.EndsWith('/') ? path.Contains(place, StringComparison.Ordinal) : path.EndsWith(place, StringComparison.Ordinal);

    static bool IsOfTwoArms(string path) => path.EndsWith("(Two Arms).unity", StringComparison.Ordinal);

    static string PathOf(Transform at) => (at.parent == null ? "" : PathOf(at.parent)) + "/" + at.name;

    [TestCaseSource(nameof(Hierarchies))]
    public void DisplayedRig_PoseNotCurrent_LooksDifferent(string path)
    {
        var roots = Path.GetExtension(path) == ".unity" ? _library.LoadScene(path).Roots : new[] { _library.Load<GameObject>(path) };
        // Excludes the rig with the true pose of the simulation, because it represents the real robot.
        var rigs = roots.SelectMany(r => r.GetComponentsInChildren<RobotRig>(true))
            .Where(r => r.Shows == RigPose.Displayed && r.GetComponent<TruthRig>() == null).ToList();

        var drawn = rigs.SelectMany(r => r.GetComponentsInChildren<MeshFilter>(true)).Select(f => f.GetComponent<Renderer>().sharedMaterial);
        var built = rigs.SelectMany(r => new[] { "_armMaterial", "_toolMaterial" }.Select(f => (Material)SerializedFields.Find(r.GetType(), f).GetValue(r)));

        var plain = drawn.Concat(built).Where(m => m.shader.name != "Nowpose/Occluder" && !(m.HasProperty("_Fade") && m.HasProperty("_Hatch")));
        Assert.That(plain.Select(m => m.name).Distinct(), Is.Empty);
        var isPart = path.EndsWith("Virtual Gripper.prefab", StringComparison.Ordinal) || path.EndsWith("Pose Label.prefab", StringComparison.Ordinal)
            || path.Contains("(MRTK3)/Prefabs/", StringComparison.Ordinal);
        Assert.That(rigs, Has.Count.EqualTo(isPart ? 0 : IsOfTwoArms(path) ? 2 : 1));
    }

    [TestCase("youBot.asset", "youbot.urdf")]
    [TestCase("UR5.asset", "ur5.urdf")]
    [TestCase("UR3e.asset", "ur3e.urdf")]
    [TestCase("UR5e.asset", "ur5e.urdf")]
    [TestCase("UR10e.asset", "ur10e.urdf")]
    [TestCase("UR16e.asset", "ur16e.urdf")]
    public void RobotDescriptionAsset_Text_EqualsTheUrdf(string asset, string urdf)
    {
        var description = _library.Load<RobotDescriptionAsset>(Runtime + "Robots/" + asset);

        Assert.That(description.Urdf, Is.EqualTo(RepositoryFiles.Read(Runtime + "Robots/" + urdf)));
    }

    [Test]
    public void ToSettings_DefaultAsset_DoesNotThrow()
    {
        var settings = _library.Load<SessionSettingsAsset>(Runtime + "Settings/Default Session Settings.asset");

        Assert.That(() => settings.ToSettings(), Throws.Nothing);
    }

    [TestCase("Nowpose Robot Cell", "Robot")]
    [TestCase("Nowpose Robot Cell", "Ghost")]
    [TestCase("Nowpose Robot Cell UR5", "Robot")]
    [TestCase("Nowpose Robot Cell UR5", "Ghost")]
    public void Rig_AsSaved_MatchesForwardKinematicsWithJointsAtZero(string cell, string rigName)
    {
        var (rig, model) = Rig(cell, rigName);
        var expected = new ForwardPoses(model).At(new double[model.MovingJoints.Count]);

        for (var i = 0; i < model.Links.Count; i++)
        {
            var link = rig.GetComponentsInChildren<Transform>(true).Single(t => t.name == model.Links[i].Name);
            RequireAt(rig.transform, link, expected[i], "link " + link.name);
        }
    }

    [TestCase("Nowpose Robot Cell", "Robot", 11)]
    [TestCase("Nowpose Robot Cell", "Ghost", 12)]
    [TestCase("Nowpose Robot Cell UR5", "Robot", 13)]
    [TestCase("Nowpose Robot Cell UR5", "Ghost", 14)]
    public void Rig_RandomJoints_MatchesForwardKinematics(string cell, string rigName, int seed)
    {
        var (rig, model) = Rig(cell, rigName);
        var saved = rig.GetComponentsInChildren<Transform>(true).ToHashSet();
        var poses = new ForwardPoses(model);
        var random = new System.Random(seed);
        rig.transform.SetPositionAndRotation(new Vector3(0.7f, -0.2f, 0.4f), Quaternion.Euler(10, 200, -30));
        rig.Bind(model);

        for (var n = 0; n < 200; n++)
        {
            var joints = model.MovingJoints.Select(j => (random.NextDouble() * 2 - 1) * (j.Kind == JointKind.Prismatic ? 0.1 : Math.PI)).ToArray();
            rig.Apply(joints);
            var expected = poses.At(joints);
            for (var i = 0; i < model.Links.Count; i++)
            {
                var link = rig.Link(model.Links[i].Name);
                Assert.That(saved, Does.Contain(link), "the rig uses the objects of the prefab");
                RequireAt(rig.transform, link, expected[i], $"seed {seed}, pose {n}, link {link.name}");
            }
        }
    }

    [Test]
    public void Gripper_OnTheYoubot_FingersMatchForwardKinematics()
    {
        var (rig, model) = Rig("Nowpose Robot Cell", "Robot");
        rig = Object.Instantiate(rig);
        var gripper = rig.GetComponentInChildren<VirtualGripper>(true);
        var poses = new ForwardPoses(model);
        var random = new System.Random(21);
        rig.Bind(model);
        gripper.Mount(rig);

        for (var n = 0; n < 50; n++)
        {
            var joints = model.MovingJoints.Select(j => random.NextDouble() * (j.Kind == JointKind.Prismatic ? 0.0115 : 2)).ToArray();
            rig.Apply(joints);
            var expected = poses.At(joints);
            RequireAt(rig.transform, gripper.transform.Find("Palm/Left Finger"), expected[model.IndexOfLink("gripper_finger_link_l")], "left, seed 21");
            RequireAt(rig.transform, gripper.transform.Find("Palm/Right Finger"), expected[model.IndexOfLink("gripper_finger_link_r")], "right, seed 21");
        }
        Object.DestroyImmediate(rig.gameObject);
    }

    [TestCase("Nowpose Robot Cell")]
    [TestCase("Nowpose Robot Cell UR5")]
    public void CellPrefab_Materials_ArmOccludesAndGripperIsDrawn(string cell)
    {
        var (rig, model) = Rig(cell, "Robot");
        var gripper = rig.GetComponentInChildren<VirtualGripper>(true).transform;

        var parts = rig.GetComponentsInChildren<MeshFilter>(true).Select(f => f.GetComponent<MeshRenderer>());
        var shown = parts.ToLookup(r => r.transform.IsChildOf(gripper), r => r.sharedMaterial.name);

        Assert.That(shown[true].Distinct(), Is.EqualTo(new[] { "Hologram" }));
        Assert.That(shown[false].Distinct(), Is.EqualTo(new[] { "Occluder" }));
        Assert.That(gripper.parent.name, Is.EqualTo(model.FlangeLink.Name));
    }

    (RobotRig Rig, RobotModel Model) Rig(string cell, string name)
    {
        var root = _library.Load<GameObject>(Runtime + "Prefabs/" + cell + ".prefab").transform;
        var rig = root.Find("Base Anchor/" + name).GetComponent<RobotRig>();
        return (rig, root.GetComponent<MrilSession>().RobotAsset.Read());
    }

    /// <summary>
    /// Compares the pose of a link with the expected pose. The tolerances, 0.01 mm and 1e-5 of the length of the axes, allow for the rounding of
    /// floats over a chain of ten links.
    /// </summary>
    static void RequireAt(Transform rig, Transform link, in RigidTransform expected, string what)
    {
        var pose = UnityFrame.ToUnity(expected);
        var position = new Vector3((float)pose.X, (float)pose.Y, (float)pose.Z);
        var rotation = new Quaternion((float)pose.RotationX, (float)pose.RotationY, (float)pose.RotationZ, (float)pose.RotationW);
        Assert.That((rig.InverseTransformPoint(link.position) - position).magnitude, Is.LessThan(1e-5), what);
        foreach (var axis in new[] { Vector3.right, Vector3.up, Vector3.forward })
        {
            var error = rig.InverseTransformDirection(link.rotation * axis) - rotation * axis;
            Assert.That(error.magnitude, Is.LessThan(1e-5), what);
        }
    }

    static IEnumerable<string> Empty(FieldInfo field, object owner)
    {
        var value = field.GetValue(owner);
        if (typeof(Object).IsAssignableFrom(field.FieldType)) return (Object)value == null ? new[] { field.Name } : Array.Empty<string>();
        if (field.FieldType != typeof(string) && value is System.Collections.IEnumerable items)
            return items.Cast<object>().SelectMany(i => i is Object or null ? (Object)i == null ? new[] { field.Name } : Array.Empty<string>() : EmptyIn(i));
        return Array.Empty<string>();
    }

    static IEnumerable<string> EmptyIn(object part) => SerializedFields.Of(part.GetType()).SelectMany(f => Empty(f, part));

    sealed class ForwardPoses
    {
        readonly ForwardKinematics _kinematics;
        readonly RigidTransform[] _poses;

        public ForwardPoses(RobotModel model)
        {
            _kinematics = new ForwardKinematics(model);
            _poses = new RigidTransform[model.Links.Count];
        }

        public RigidTransform[] At(double[] joints)
        {
            _kinematics.Compute(joints, _poses);
            return _poses;
        }
    }
}
