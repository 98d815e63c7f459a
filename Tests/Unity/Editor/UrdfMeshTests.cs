using Nowpose.Editor;
using Nowpose.Editor.Import;
using Nowpose.Kinematics;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using static Nowpose.Unity.Tests.Editor.ImportedRobot;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>Tests the meshes and materials of imported robots.</summary>
public sealed class UrdfMeshTests : EditorFixture
{
    ImportedRobot _imported;

    [SetUp]
    public void SetUp() => _imported = new ImportedRobot(this);

    [TearDown]
    public void TearDown() => _imported.Dispose();

    [TestCase("<mesh filename='../meshes/a.stl'/>", 1, 1, 1)]
    [TestCase("<mesh filename='package://arm_description/meshes/a.stl'/>", 1, 1, 1)]
    [TestCase("<mesh filename='../meshes/a.stl' scale='0.001 0.002 -0.003'/>", 0.001, 0.002, -0.003)]
    public void Import_Stl_AppliesOriginAndScaleToTheVertices(string mesh, double x, double y, double z)
    {
        _imported.Folder.Write("Assets/arm_description/meshes/a.stl", Stl(("0 0 0", "1 0 0", "0 1 0"), ("10 20 30", "11 20 30", "10 20 31")));

        var robot = _imported.Import("<link name='base'>" + Visual(mesh, Moved) + "</link>");

        var shown = robot.transform.Find("base/visual");
        var at = shown.TransformPoint(shown.GetComponent<MeshFilter>().sharedMesh.vertices[3]);
        RequireAt(at, RigidTransform.FromXyzRpy(1, 2, 3, 0.3, -0.2, 0.7) * RigidTransform.FromXyzRpy(10 * x, 20 * y, 30 * z, 0, 0, 0));
        Assert.That(_imported.Context.SourceDependencies, Is.EqualTo(new[] { "Assets/arm_description/meshes/a.stl" }));
        Assert.That(_imported.Context.Warnings, Is.Empty);
    }

    [Test]
    public void Import_Stl_FacesOutwards()
    {
        _imported.Folder.Write("Assets/arm_description/meshes/a.stl", Stl(("0 0 0", "1e-3 0 0", "0 1e-3 0")));

        _imported.Import("<link name='base'>" + Visual("<mesh filename='../meshes/a.stl'/>") + "</link>");

        // The triangle is anticlockwise about z in the file. This axis is Unity's y, and Unity draws triangles that are clockwise.
        var mesh = _imported.Objects().OfType<Mesh>().Single();
        var corners = mesh.triangles.Select(i => mesh.vertices[i]).ToArray();
        Assert.That(mesh.normals, Is.All.EqualTo(Vector3.up));
        Assert.That(Vector3.Dot(Vector3.Cross(corners[1] - corners[0], corners[2] - corners[0]), Vector3.up), Is.GreaterThan(0));
    }

    [Test]
    public void Import_Stl_SharesCornersWithinAPlaneAndKeepsEdgesSharp()
    {
        _imported.Folder.Write("Assets/arm_description/meshes/a.stl", Stl(
            ("0 0 0", "1 0 0", "1 1 0"), ("0 0 0", "1 1 0", "0 1 0"), ("0 0 0", "0 1 0", "0 0 1")));

        _imported.Import("<link name='base'>" + Visual("<mesh filename='../meshes/a.stl'/>") + "</link>");

        var mesh = _imported.Objects().OfType<Mesh>().Single();
        Assert.That(mesh.triangles.Length, Is.EqualTo(9));
        Assert.That(mesh.vertexCount, Is.EqualTo(4 + 3));
    }

    [Test]
    public void Import_StlWithManyCorners_Has32BitIndices()
    {
        _imported.Folder.Write("Assets/arm_description/meshes/a.stl", Stl(Enumerable.Range(0, 22_000)
            .Select(i => ($"{i} 0 0", $"{i} 1 0", $"{i} 0 {1 + i % 7}")).ToArray()));

        _imported.Import("<link name='base'>" + Visual("<mesh filename='../meshes/a.stl'/>") + "</link>");

        Assert.That(_imported.Objects().OfType<Mesh>().Single().indexFormat, Is.EqualTo(UnityEngine.Rendering.IndexFormat.UInt32));
    }

    [Test]
    public void Import_StlUsedTwice_CreatesOneMesh()
    {
        _imported.Folder.Write("Assets/arm_description/meshes/a.stl", Stl(("0 0 0", "1 0 0", "0 1 0")));

        _imported.Import("<link name='base'>" + Visual("<mesh filename='../meshes/a.stl'/>")
            + Visual("<mesh filename='package://arm_description/meshes/a.stl'/>") + "</link>");

        Assert.That(_imported.Objects().OfType<Mesh>().Count(), Is.EqualTo(1));
    }

    [TestCase("a.obj", UpAxis.Y, false)]
    [TestCase("a.dae", UpAxis.X, false)]
    [TestCase("a.DAE", UpAxis.Y, false)]
    [TestCase("a.dae", UpAxis.Z, false)]
    [TestCase("a.fbx", UpAxis.Y, false)]
    [TestCase("a.fbx", UpAxis.Z, false)]
    [TestCase("a.fbx", UpAxis.Z, true)]
    public void Import_ModelWithAnyUpAxis_IsPlacedAsInTheUrdf(string file, object up, bool isBaked)
    {
        var path = "Assets/arm_description/meshes/" + file;
        _imported.Folder.Write(path, Header(file, (UpAxis)up));
        Project.Put(path, AsUnityImports((10, 20, 30), (UpAxis)up, isBaked));

        var robot = _imported.Import("<link name='base'>" + Visual($"<mesh filename='../meshes/{file}' scale='0.1 0.2 -0.3'/>", Moved) + "</link>");

        var shown = robot.GetComponentInChildren<MeshFilter>();
        RequireAt(
            shown.transform.TransformPoint(shown.sharedMesh.vertices[0]),
            RigidTransform.FromXyzRpy(1, 2, 3, 0.3, -0.2, 0.7) * RigidTransform.FromXyzRpy(1, 4, -9, 0, 0, 0));
        Assert.That(_imported.Context.ArtifactDependencies, Does.Contain(path));
        Assert.That(_imported.Context.Warnings, Is.Empty);
    }

    [Test]
    public void Import_Model_IsACopyWithoutForeignComponents()
    {
        _imported.Folder.Write("Assets/arm_description/meshes/a.obj", "v 0 0 0");
        var model = AsUnityImports((1, 2, 3), UpAxis.Y, isBaked: true);
        model.AddComponent<Camera>();
        Project.Put("Assets/arm_description/meshes/a.obj", model);

        var robot = _imported.Import("<link name='base'>" + Visual("<mesh filename='../meshes/a.obj'/>") + "</link>");

        Assert.That(robot.GetComponentsInChildren<Camera>(true), Is.Empty);
        Assert.That(model.GetComponent<Camera>() != null, "the imported model is unchanged");
        Assert.That(robot.GetComponentInChildren<MeshFilter>().sharedMesh, Is.SameAs(model.GetComponent<MeshFilter>().sharedMesh));
        Assert.That(robot.GetComponentInChildren<Renderer>().sharedMaterial, Is.SameAs(model.GetComponent<Renderer>().sharedMaterial));
    }

    [Test]
    public void Import_ModelWithPartsNamedLikeLinks_IsNotMistakenForLinks()
    {
        _imported.Folder.Write("Assets/arm_description/meshes/a.obj", "v 0 0 0");
        var model = AsUnityImports((1, 2, 3), UpAxis.Y, isBaked: true);
        new GameObject("tip").transform.SetParent(model.transform);
        Project.Put("Assets/arm_description/meshes/a.obj", model);

        var robot = _imported.Import("<link name='base'>" + Visual("<mesh filename='../meshes/a.obj'/>") + "</link><link name='tip'/>"
            + "<joint name='j' type='revolute'><parent link='base'/><child link='tip'/></joint>");

        var rig = robot.GetComponent<RobotRig>();
        rig.Bind(_imported.Objects().OfType<RobotDescriptionAsset>().Single().Read());
        Assert.That(rig.Link("tip"), Is.SameAs(robot.transform.Find("base/tip")));
    }

    [Test]
    public void Import_SeveralVisualsOfOneKind_HaveUniqueNames()
    {
        _imported.Folder.Write("Assets/arm_description/meshes/a.stl", Stl(("0 0 0", "1 0 0", "0 1 0")));
        _imported.Folder.Write("Assets/arm_description/meshes/a.obj", "v 0 0 0");
        var model = AsUnityImports((1, 2, 3), UpAxis.Y, isBaked: true);
        foreach (var part in new[] { "left", "right" }) new GameObject(part).transform.SetParent(model.transform);
        Project.Put("Assets/arm_description/meshes/a.obj", model);

        var robot = _imported.Import("<link name='base'>" + Visual("<mesh filename='../meshes/a.stl'/>")
            + Visual("<mesh filename='../meshes/a.obj'/>")
            + Visual("<box size='1 1 1'/>") + "</link>");

        Assert.That(robot.transform.Find("base").Cast<Transform>().Select(s => s.name), Is.EqualTo(new[] { "visual", "visual 2", "visual 3" }));
        var copy = robot.transform.Find("base/visual 2/axes/mesh");
        Assert.That(copy.Cast<Transform>().Select(s => s.name), Is.EqualTo(new[] { "mesh", "mesh 2" }));
        Assert.That(_imported.Context.Warnings, Is.Empty);
    }

    [Test]
    public void Import_MaterialsChosen_UsesThemForAllParts()
    {
        _imported.Folder.Write("Assets/arm_description/meshes/a.stl", Stl(("0 0 0", "1 0 0", "0 1 0")));
        _imported.Folder.Write("Assets/arm_description/meshes/a.obj", "v 0 0 0");
        Project.Put("Assets/arm_description/meshes/a.obj", AsUnityImports((1, 2, 3), UpAxis.Y, isBaked: true));
        Material arm = NewMaterial(), tool = NewMaterial();
        var importer = new UrdfImporter();
        importer.With("_armMaterial", arm).With("_toolMaterial", tool);

        var robot = _imported.Import(
            "<link name='base'>" + Visual("<box size='1 1 1'/>") + Visual("<mesh filename='../meshes/a.obj'/>") + "</link>"
            + "<link name='flange'>" + Visual("<mesh filename='../meshes/a.stl'/>") + "</link><link name='tool0'>"
            + Visual("<sphere radius='1'/>") + Visual("<mesh filename='../meshes/a.obj'/>") + "</link>"
            + "<joint name='j' type='revolute'><parent link='base'/><child link='flange'/></joint>"
            + "<joint name='k' type='fixed'><parent link='flange'/><child link='tool0'/></joint>", importer);

        var materials = robot.GetComponentsInChildren<Renderer>().Select(r => r.sharedMaterial);
        Assert.That(materials, Is.EqualTo(new[] { arm, arm, arm, tool, tool }));
        Assert.That(_imported.Objects().OfType<Material>(), Is.Empty);
    }

    static string Header(string file, UpAxis up) => Path.GetExtension(file).ToLowerInvariant() switch
    {
        ".dae" => $"<COLLADA><asset><up_axis>{up}_UP</up_axis></asset></COLLADA>",
        ".fbx" => $"; FBX\nP: \"UpAxis\", \"int\", \"Integer\", \"\",{(int)up}\n",
        _ => "v 0 0 0",
    };

    /// <summary>
    /// Simulates Unity's model importer: mirrors x, and turns the up axis to y by the rotation of the root or, if baked, of the vertices.
    /// </summary>
    GameObject AsUnityImports((float X, float Y, float Z) point, UpAxis up, bool isBaked)
    {
        var model = Keep(new GameObject("model"));
        var turn = up switch
        {
            UpAxis.X => Quaternion.Euler(0, 0, -90),
            UpAxis.Z => Quaternion.Euler(-90, 0, 0),
            _ => Quaternion.identity,
        };
        var mirrored = new Vector3(-point.X, point.Y, point.Z);
        model.transform.localRotation = isBaked ? Quaternion.identity : turn;
        model.AddComponent<MeshFilter>().sharedMesh = Keep(new Mesh { vertices = new[] { isBaked ? turn * mirrored : mirrored } });
        model.AddComponent<MeshRenderer>().sharedMaterial = NewMaterial();
        return model;
    }

    Material NewMaterial() => Keep(new Material(Shader.Find("Standard")));

    static void RequireAt(Vector3 actual, RigidTransform expected)
    {
        var (x, y, z) = UnityFrame.DirectionToUnity((expected.X, expected.Y, expected.Z));
        Assert.That(Vector3.Distance(actual, new Vector3((float)x, (float)y, (float)z)), Is.LessThan(1e-5f), actual + " is not " + (x, y, z));
    }
}
