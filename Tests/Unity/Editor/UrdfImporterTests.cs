using Nowpose.Editor;
using Nowpose.Editor.Messages;
using Nowpose.Messages;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using static Nowpose.Unity.Tests.Editor.ImportedRobot;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>Tests the import of robots of a user's project in the stand-in editor.</summary>
public sealed class UrdfImporterTests : EditorFixture
{
    ImportedRobot _imported;

    [SetUp]
    public void SetUp() => _imported = new ImportedRobot(this);

    [TearDown]
    public void TearDown() => _imported.Dispose();

    [Test]
    public void Import_Shapes_HaveTheirSizesAndColours()
    {
        var robot = _imported.Import("<link name='base'>"
            + Visual("<box size='1 2 3'/>", Moved, "<material name='m'><color rgba='1 0.5 0 1'/></material>")
            + Visual("<cylinder radius='0.5' length='4'/>") + Visual("<sphere radius='2'/>") + "</link>");

        var shown = robot.transform.Find("base").Cast<Transform>().ToArray();
        Assert.That(shown.Select(s => s.GetComponent<MeshFilter>().sharedMesh.name), Is.EqualTo(new[] { "Cube", "Cylinder", "Sphere" }));
        Assert.That(shown.Select(s => s.localScale), Is.EqualTo(new[] { new Vector3(2, 3, 1), new Vector3(1, 2, 1), new Vector3(4, 4, 4) }));
        Assert.That(shown[0].localPosition, Is.EqualTo(new Vector3(-2, 3, 1)));
        Assert.That(shown[0].GetComponent<Renderer>().sharedMaterial.name, Is.EqualTo("#ff8000ff"));
        Assert.That(shown[1].GetComponent<Renderer>().sharedMaterial.name, Is.EqualTo("#ccccccff"));
        Assert.That(shown[2].GetComponent<Renderer>().sharedMaterial, Is.SameAs(shown[1].GetComponent<Renderer>().sharedMaterial));
        Assert.That(_imported.Context.Errors.Concat(_imported.Context.Warnings), Is.Empty);
    }

    [Test]
    public void Import_AnyRobot_HasARigAtTheRootAndADescription()
    {
        var robot = _imported.Import("<link name='base'/>");

        Assert.That(robot.name, Is.EqualTo("arm"));
        Assert.That(robot.GetComponent<RobotRig>() != null);
        Assert.That(_imported.Context.mainObject, Is.SameAs(robot));
        Assert.That(_imported.Objects().OfType<RobotDescriptionAsset>().Single().Urdf, Is.EqualTo(_imported.Folder.Read(Urdf)));
        Assert.That(_imported.Objects().OfType<RobotDescriptionAsset>().Single().Read().Root.Name, Is.EqualTo("base"));
    }

    [Test]
    public void Import_AnyRobot_LooksDifferentWhileItsPoseIsNotCurrent()
    {
        var hologram = Keep(new Material((Shader)null));
        Project.PutAs(PackageAsset.Hologram.Guid, "Hologram.mat", hologram);

        var robot = _imported.Import("<link name='base'/>");

        Assert.That(robot.GetComponent<PoseAppearance>().Substitute, Is.SameAs(hologram), "the materials of models cannot fade");
        Assert.That(_imported.Context.ArtifactDependencies, Does.Contain("Hologram.mat"));
    }

    [Test]
    public void Import_MeshMissing_CausesOneWarningAndImportsTheRest()
    {
        var robot = _imported.Import("<link name='base'>" + Visual("<mesh filename='package://other/a.dae'/>")
            + Visual("<mesh filename='package://other/a.dae'/>") + Visual("<box size='1 1 1'/>") + "</link>");

        Assert.That(robot.transform.Find("base").childCount, Is.EqualTo(1));
        Assert.That(_imported.Context.Warnings.Single(), Does.Match(
            $"^arm.urdf: {MeshMessages.Of(MeshMessages.NotFound("package://other/a.dae", "Assets/.+"))}$"));
        Assert.That(_imported.Context.Errors, Is.Empty);
        Assert.That(_imported.Context.SourceDependencies, Does.Contain("Assets/arm_description/other/a.dae"));
        Assert.That(_imported.Context.SourceDependencies, Does.Contain("Packages/other/a.dae"));
    }

    [Test]
    public void Import_LinkWithOnlyMissingMeshes_IsDrawnAsBars()
    {
        var robot = _imported.Import("<link name='base'>" + Visual("<mesh filename='a.stl'/>") + "</link><link name='tip'/>"
            + "<joint name='j' type='fixed'><parent link='base'/><child link='tip'/><origin xyz='0 0 2'/></joint>");

        var bar = robot.GetComponentInChildren<Renderer>();
        Assert.That(bar.transform.localPosition, Is.EqualTo(new Vector3(0, 1, 0)));
        Assert.That(bar.sharedMaterial != null);
    }

    static readonly string[][] InvalidMeshes =
    [
        ["a.stl", "solid a\nfacet\nvertex 0 0\n", "Assets/arm_description/urdf/a.stl:3: " + StlMessages.VertexNumbers(2)],
        ["a.ply", "ply", MeshMessages.Format("a.ply")],
        ["a.fbx", "broken", MeshMessages.NotImported("Assets/arm_description/urdf/a.fbx")],
    ];

    [TestCaseSource(nameof(InvalidMeshes))]
    public void Import_MeshInvalid_CausesOneWarningWithTheNameOfTheFile(string file, string content, string warning)
    {
        _imported.Folder.Write("Assets/arm_description/urdf/" + file, content);

        _imported.Import($"<link name='base'>{Visual($"<mesh filename='{file}'/>")}{Visual($"<mesh filename='{file}'/>")}</link>");

        Assert.That(_imported.Context.Warnings, Is.EqualTo(new[] { "arm.urdf: " + warning }));
        Assert.That(_imported.Context.Errors, Is.Empty);
        Assert.That(_imported.Context.ArtifactDependencies.Concat(_imported.Context.SourceDependencies), file == "a.ply"
            ? Is.Empty
            : Is.EqualTo(new[] { "Assets/arm_description/urdf/" + file }), "imported again once it is repaired");
    }

    static readonly string[][] InvalidRobots =
    [
        ["<link name='a'/>\n<link name='b'/>", "link 'b': " + UrdfMessages.TwoRoots("'a'")],
        ["<link", UrdfMessages.NotWellFormed("")],
    ];

    [TestCaseSource(nameof(InvalidRobots))]
    public void Import_NotARobot_CausesOneErrorWithFileAndLine(string body, string error)
    {
        Assert.That(_imported.Import(body) == null);
        Assert.That(_imported.Context.Errors.Single(), Does.StartWith("arm.urdf:3: " + error));
        Assert.That(_imported.Objects(), Is.Empty);
    }

    [Test]
    public void Import_FileTooLong_CausesOneErrorAndIsNotRead()
    {
        _imported.Folder.Write(Urdf, "");
        using (var file = File.OpenWrite(Path.Combine(_imported.Folder.Root, Urdf))) file.SetLength((16 << 20) + 1);

        _imported.Context = Importers.Import(new UrdfImporter(), Urdf).Context;

        Assert.That(_imported.Context.Errors, Is.EqualTo(new[] { MeshMessages.UrdfTooLong("arm.urdf", 16777217, 16777216) }));
    }

    [Test]
    public void Import_SameFileTwice_HasTheSameIdentifiers()
    {
        _imported.Folder.Write("Assets/arm_description/meshes/a.stl", Stl(("0 0 0", "1 0 0", "0 1 0")));
        var body = "<link name='base'>" + Visual("<mesh filename='../meshes/a.stl'/>") + Visual("<box size='1 1 1'/>") + "</link>";
        _imported.Import(body);
        var once = _imported.Context.Identifiers;

        _imported.Import(body);

        Assert.That(_imported.Context.Identifiers, Is.EquivalentTo(once));
        Assert.That(once, Is.EquivalentTo(new[] { "robot", "description", "mesh Assets/arm_description/meshes/a.stl", "material #ccccccff" }));
    }

    [Test]
    public void GatherDependencies_BeforeTheImport_ReturnsTheExistingModels()
    {
        _imported.Folder.Write("Assets/arm_description/meshes/a.dae", "");
        _imported.Folder.Write("Assets/arm_description/meshes/a.stl", "");
        _imported.Folder.Write(Urdf, ImportedRobot.Robot("<link name='base'>" + Visual("<mesh filename='../meshes/a.dae'/>")
            + Visual("<mesh filename='../meshes/a.dae'/>") + Visual("<mesh filename='../meshes/b.dae'/>") + Visual("<mesh filename='../meshes/a.stl'/>")
            + Visual("<sphere radius='1'/>") + "</link>"));

        Assert.That(Gather(Urdf), Is.EqualTo(new[] { "Assets/arm_description/meshes/a.dae" }));
    }

    [TestCase("<link")]
    [TestCase(null)]
    public void GatherDependencies_InvalidRobot_ReturnsNothing(string body)
    {
        if (body != null) _imported.Folder.Write(Urdf, ImportedRobot.Robot(body));

        Assert.That(Gather(Urdf), Is.Empty);
    }

    static string[] Gather(string path) => Project.InRoot(() => UrdfImporter.GatherDependenciesFromSourceFile(path));
}
