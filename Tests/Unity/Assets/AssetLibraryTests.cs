using Nowpose.UnityPlayer.Assets;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Assets.ProbedProject;
using static Nowpose.Unity.Tests.Assets.TemporaryProject;

namespace Nowpose.Unity.Tests.Assets;

/// <summary>Tests that prefabs, assets and materials are loaded with the values in their files.</summary>
public sealed class AssetLibraryTests
{
    ProbedProject _probed;

    [SetUp]
    public void SetUp() => _probed = new ProbedProject();

    [TearDown]
    public void TearDown() => _probed.Dispose();

    [Test]
    public void Load_Prefab_HasHierarchyNamesAndTransforms()
    {
        var arm = _probed.Load("");

        Assert.That((arm.name, arm.layer, arm.tag, arm.activeSelf), Is.EqualTo(("Arm", 5, "Player", true)));
        Assert.That(arm.transform.localPosition, Is.EqualTo(new Vector3(1, -2, 0.25f)));
        Assert.That(arm.transform.localRotation, Is.EqualTo(new Quaternion(0, 0.6f, 0, 0.8f)));
        var hand = arm.transform.GetChild(0).gameObject;
        Assert.That((hand.name, hand.activeSelf, arm.transform.childCount), Is.EqualTo(("Hand", false, 1)));
        Assert.That(hand.transform.position, Is.EqualTo(new Vector3(1, -2, 0.25f)));
    }

    [Test]
    public void Load_Prefab_IsNotASceneObjectAndCannotBeDestroyed()
    {
        using var player = new Nowpose.UnityPlayer.Player();
        var before = player.ObjectCount;
        var arm = _probed.Load("");

        UnityEngine.Object.Destroy(arm);
        UnityEngine.Object.DestroyImmediate(arm.transform.GetChild(0).gameObject);
        player.Step(1);

        Assert.That(player.ObjectCount, Is.EqualTo(before));
        Assert.That((arm != null, arm.transform.childCount, player.Logs.Count), Is.EqualTo((true, 1, 2)));
        Assert.That(UnityEngine.Object.FindObjectOfType<Transform>(true) == null);
        Assert.That((arm.activeInHierarchy, arm.scene.IsValid()), Is.EqualTo((false, false)));
    }

    [Test]
    public void Load_FieldsOfEveryKind_AreSet()
    {
        _probed.Project.AddYaml("Assets/Data.asset", 4, Scriptable("Data", "  _text: hello\n"));

        var probe = _probed.Probe("""
              _inherited: 2.5
              _flag: 1
              number: -7
              exact: 1e-3
              text: 'it''s'
              shape: 3
              flags: 3
              place: {x: 1, y: 2, z: 3}
              turn: {x: 0, y: 0, z: 1, w: 0}
              colour: {r: 0.1, g: 0.2, b: 0.3, a: 0.4}
              bytes:
                serializedVersion: 2
                rgba: 4278255873
              other: {fileID: 12}
              thing: {fileID: 11}
              probe: {fileID: 3}
              asset: {fileID: 11400000, guid: 00000000000000000000000000000004, type: 2}
              material: {fileID: 10303, guid: 0000000000000000f000000000000000, type: 0}
              words:
              - one
              - 
              transforms:
              - {fileID: 12}
              - {fileID: 0}
              parts:
              - name: a
                size: 2
                where: {fileID: 2}
              - name: b
              part:
                size: 9
              renamed: 4
            """);

        Assert.That((probe.Inherited, probe.Flag, probe.number, probe.exact, probe.text), Is.EqualTo((2.5f, true, -7, 1e-3, "it's")));
        Assert.That((probe.shape, probe.flags), Is.EqualTo((PrimitiveType.Cube, HideFlags.HideInHierarchy | HideFlags.HideInInspector)));
        Assert.That((probe.place, probe.turn), Is.EqualTo((new Vector3(1, 2, 3), new Quaternion(0, 0, 1, 0))));
        Assert.That(probe.colour, Is.EqualTo(new Color(0.1f, 0.2f, 0.3f, 0.4f)));
        Assert.That((probe.bytes.r, probe.bytes.g, probe.bytes.b, probe.bytes.a), Is.EqualTo((1, 1, 1, 255)));
        var hand = probe.transform.GetChild(0);
        Assert.That((probe.other, probe.thing, probe.probe), Is.EqualTo((hand, hand.gameObject, probe)));
        Assert.That((probe.asset.Text, probe.asset.TextOnEnable, probe.material.name), Is.EqualTo(("hello", "hello", "Default-Material")));
        Assert.That(probe.words, Is.EqualTo(new[] { "one", "" }));
        Assert.That(probe.transforms, Is.EqualTo(new[] { hand, null }));
        Assert.That(probe.parts.Select(p => (p.name, p.size, p.where)),
            Is.EqualTo(new[] { ("a", 2f, probe.transform), ("b", 0.5f, (Transform)null) }));
        Assert.That((probe.part.size, probe.renamed, probe.Deserialised, probe.enabled), Is.EqualTo((9f, 4, -7, false)));
    }

    [Test]
    public void Load_FieldsMissingFromTheFile_KeepTheirDefaults()
    {
        var probe = _probed.Probe("");

        Assert.That((probe.number, probe.text, probe.words.Single(), probe.Inherited), Is.EqualTo((1, "default", "kept unless told otherwise", 1f)));
    }

    [TestCase("oldName")]
    [TestCase("olderName")]
    public void Load_FormerName_SetsTheRenamedField(string name)
    {
        Assert.That(_probed.Probe("  " + name + ": 4").renamed, Is.EqualTo(4));
    }

    [Test]
    public void Load_EventWithPersistentCalls_RunsThemWhenRaised()
    {
        const string Call = """
                  - m_Target: {fileID: 3}
                    m_TargetAssemblyTypeName: Nowpose.Unity.Tests.Assets.LoaderProbe, Nowpose.Unity.Tests
                    m_MethodName: NAME
                    m_Mode: MODE
                    m_Arguments:
                      m_ObjectArgument: {fileID: 0}
                      m_ObjectArgumentAssemblyTypeName: UnityEngine.Object, UnityEngine
                      m_IntArgument: 42
                      m_FloatArgument: 0
                      m_StringArgument: 
                      m_BoolArgument: 0
                    m_CallState: 1

            """;
        var calls = Call.Replace("NAME", "Call").Replace("MODE", "1") + Call.Replace("NAME", "CallWith").Replace("MODE", "3");
        var probe = _probed.Probe("  called:\n    m_PersistentCalls:\n      m_Calls:\n" + calls);

        Assert.That(probe.called.GetPersistentEventCount(), Is.EqualTo(2));
        Assert.That(probe.called.GetPersistentTarget(0), Is.SameAs(probe));
        Assert.That(probe.called.GetPersistentMethodName(1), Is.EqualTo("CallWith"));
        probe.called.Invoke();
        Assert.That(probe.Calls, Is.EqualTo(new[] { 0, 42 }));
    }

    [Test]
    public void Load_AssetsReferToEachOther_ReferencesAreTheSameObjects()
    {
        _probed.Project.AddYaml("Assets/A.asset", 4, Scriptable("A", "  _next: {fileID: 11400000, guid: " + GuidOf(5) + ", type: 2}\n"))
            .AddYaml("Assets/B.asset", 5, Scriptable("B", "  _next: {fileID: 11400000, guid: " + GuidOf(4) + ", type: 2}\n"));
        var library = _probed.Project.Library();

        var a = library.Load<LoaderProbeAsset>("Assets/A.asset");

        Assert.That(a.Next.Next, Is.SameAs(a));
        Assert.That(library.Load<LoaderProbeAsset>("Assets/B.asset"), Is.SameAs(a.Next));
    }

    [Test]
    public void Load_TextAsset_HasTheText()
    {
        _probed.Project.Add("Assets/Words.txt", 4, "some words\n");

        Assert.That(_probed.Project.Library().Load<TextAsset>("Assets/Words.txt").text, Is.EqualTo("some words\n"));
    }

    [Test]
    public void Load_Material_HasTheShadersDefaultsAndItsOwnValues()
    {
        const string Shader = "Shader \"Test/One\"\n{\n  Properties\n  {\n    // _No (\"No\", Float) = 1\n"
            + "    _Color (\"C\", Color) = (1, 0.5, 0, 1)\n"
            + "    _Fade (\"F (0: none)\", Range(0, 1)) = 0.25\n    _Size (\"S\", Float) = 3\n  }\n  SubShader { }\n}\n";
        const string Material = """
            --- !u!21 &2100000
            Material:
              serializedVersion: 8
              m_Name: Red
              m_Shader: {fileID: 4800000, guid: 00000000000000000000000000000004, type: 3}
              m_CustomRenderQueue: 2900
              m_SavedProperties:
                serializedVersion: 3
                m_TexEnvs: []
                m_Ints: []
                m_Floats:
                - _Size: 7
                m_Colors: []

            """;
        _probed.Project.Add("Assets/One.shader", 4, Shader, "ShaderImporter").AddYaml("Assets/Red.mat", 5, Material);

        var red = _probed.Project.Library().Load<Material>("Assets/Red.mat");

        Assert.That((red.name, red.shader.name, red.renderQueue), Is.EqualTo(("Red", "Test/One", 2900)));
        Assert.That((red.GetFloat("_Size"), red.GetFloat("_Fade"), red.color), Is.EqualTo((7f, 0.25f, new Color(1, 0.5f, 0, 1))));
        Assert.That(red.HasProperty("_No"), Is.False);
        Assert.That(() => _probed.Project.AddYaml("Assets/Red.mat", 5, Material.Replace("_Size", "_Sise")).Library().Load<Material>("Assets/Red.mat"),
            Refused(AssetFault.UnknownField, "Assets/Red.mat &2100000 Material.m_SavedProperties.m_Floats._Sise"));
    }
}
