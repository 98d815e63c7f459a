using Nowpose.UnityPlayer.Assets;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Assets.ProbedProject;
using static Nowpose.Unity.Tests.Assets.TemporaryProject;

namespace Nowpose.Unity.Tests.Assets;

/// <summary>
/// Tests that invalid assets, which Unity would load with values other than those in the text, are refused. The error must name file, id and field.
/// </summary>
public sealed class InvalidAssetTests
{
    ProbedProject _probed;

    [SetUp]
    public void SetUp() => _probed = new ProbedProject();

    [TearDown]
    public void TearDown() => _probed.Dispose();

    [TestCase("  number: two", AssetFault.Value, "Assets/Arm.prefab &3 LoaderProbe.number", "\"two\"")]
    [TestCase("  number: 1e3", AssetFault.Value, "LoaderProbe.number", "1e3")]
    [TestCase("  number: 3000000000", AssetFault.Value, "LoaderProbe.number", "3000000000")]
    [TestCase("  exact: .nan", AssetFault.Value, "LoaderProbe.exact", ".nan")]
    [TestCase("  _flag: true", AssetFault.Value, "LoaderProbe._flag", "true")]
    [TestCase("  shape: 77", AssetFault.Value, "LoaderProbe.shape", "77")]
    [TestCase("  nonsense: 1", AssetFault.UnknownField, "LoaderProbe", "nonsense")]
    [TestCase("  _private: 1", AssetFault.UnknownField, "LoaderProbe", "_private")]
    [TestCase("  unserialised: 1", AssetFault.UnknownField, "LoaderProbe", "unserialised")]
    [TestCase("  unwritable: 1", AssetFault.UnknownField, "LoaderProbe", "unwritable")]
    [TestCase("  unknown: 1", AssetFault.UnknownField, "LoaderProbe", "unknown")]
    [TestCase("  Property: 1", AssetFault.UnknownField, "LoaderProbe", "Property")]
    [TestCase("  place: {x: 1, q: 2}", AssetFault.UnknownField, "LoaderProbe.place", "q")]
    [TestCase("  place: 1", AssetFault.Kind, "LoaderProbe.place", "\"1\"")]
    [TestCase("  words: one", AssetFault.Kind, "LoaderProbe.words", "\"one\"")]
    [TestCase("  parts:\n  - nmae: a", AssetFault.UnknownField, "LoaderProbe.parts[0]", "nmae")]
    [TestCase("  other: 5", AssetFault.Kind, "LoaderProbe.other", "")]
    [TestCase("  other: {fileID: 99}", AssetFault.MissingObject, "&3 MonoBehaviour.other", "99")]
    [TestCase("  other: {fileID: 11}", AssetFault.Reference, "LoaderProbe.other", "{fileID: 11}")]
    [TestCase("  transforms:\n  - {fileID: 98}", AssetFault.MissingObject, "&3 MonoBehaviour.transforms", "98")]
    [TestCase("  asset: {fileID: 11400000, guid: 000000000000000000000000000000ff, type: 2}", AssetFault.MissingAsset, "LoaderProbe.asset", "ff")]
    [TestCase("  asset: {fileID: 11400000, guid: 00000000000000000000000000000001, type: 2}",
        AssetFault.Reference, "LoaderProbe.asset", "Assets/Scripts/LoaderProbe.cs")]
    [TestCase("  asset: {fileID: 11400000, guid: 00000000000000000000000000000003, type: 2}",
        AssetFault.Reference, "LoaderProbe.asset", "Assets/Arm.prefab has type: 3")]
    [TestCase("  thing: {fileID: 77, guid: 00000000000000000000000000000003, type: 3}", AssetFault.MissingObject, "LoaderProbe.thing", "77")]
    [TestCase("  material: {fileID: 99, guid: 0000000000000000f000000000000000, type: 0}",
        AssetFault.MissingObject, "LoaderProbe.material", "fileID: 99")]
    [TestCase("  m_Name: x", AssetFault.Unsupported, "LoaderProbe.m_Name", "x")]
    public void Load_InvalidField_IsRefusedWithFileIdAndField(string fields, object fault, string place, string detail)
    {
        Assert.That(() => _probed.Probe(fields), Refused(fault, place, detail));
    }

    [TestCase("guid: 00000000000000000000000000000001, type: 3", "guid: 00000000000000000000000000000077, type: 3",
        AssetFault.MissingAsset, "&3 MonoBehaviour.m_Script", "77")]
    [TestCase("guid: 00000000000000000000000000000001, type: 3", "guid: 00000000000000000000000000000002, type: 3",
        AssetFault.Script, "&3 MonoBehaviour.m_Script", "Assets/Scripts/LoaderProbeAsset.cs")]
    [TestCase("fileID: 11500000", "fileID: 11400000", AssetFault.Kind, "&3 MonoBehaviour.m_Script", "")]
    [TestCase("  - {fileID: 12}\n", "  - {fileID: 13}\n", AssetFault.MissingObject, "&2 Transform.m_Children", "13")]
    [TestCase("  - {fileID: 12}\n", "  - {fileID: 12}\n  - {fileID: 12}\n", AssetFault.Duplicate, "&2 Transform.m_Children", "")]
    [TestCase("m_Children:\n  - {fileID: 12}", "m_Children: []", AssetFault.Hierarchy, "&12 Transform.m_Father", "&2")]
    [TestCase("m_Father: {fileID: 2}", "m_Father: {fileID: 0}", AssetFault.Hierarchy, "&12 Transform.m_Father", "&2")]
    [TestCase("m_Father: {fileID: 2}", "m_Father: {fileID: 1}", AssetFault.Hierarchy, "&12 Transform.m_Father", "&2")]
    [TestCase("m_GameObject: {fileID: 11}", "m_GameObject: {fileID: 1}", AssetFault.Hierarchy, "&12 Transform.m_GameObject", "&11")]
    [TestCase("  - component: {fileID: 3}\n", "", AssetFault.Hierarchy, "&3 MonoBehaviour", "")]
    [TestCase("  - component: {fileID: 3}\n", "  - component: {fileID: 4}\n", AssetFault.MissingObject, "&1 GameObject.m_Component", "4")]
    [TestCase("  - component: {fileID: 2}\n", "", AssetFault.Hierarchy, "&3 MonoBehaviour", "")]
    [TestCase("!u!4 &12\nTransform", "!u!33 &12\nMeshFilter", AssetFault.Hierarchy, "&12 MeshFilter", "")]
    [TestCase("!u!114 &3\nMonoBehaviour", "!u!999 &3\nWobble", AssetFault.Unsupported, "&3 Wobble", "")]
    [TestCase("m_Layer: 5", "m_Lair: 5", AssetFault.UnknownField, "&1 GameObject", "m_Lair")]
    public void Load_InvalidHierarchy_IsRefused(string good, string bad, object fault, string place, string detail)
    {
        var text = Arm.Replace("PROBE\n", "", StringComparison.Ordinal);
        Assert.That(text, Does.Contain(good), "the text contains the part that the test replaces");

        _probed.Project.AddYaml("Assets/Arm.prefab", 3, text.Replace(good, bad, StringComparison.Ordinal));

        Assert.That(() => _probed.Project.Library().Load<GameObject>("Assets/Arm.prefab"), Refused(fault, place, detail));
    }

    [Test]
    public void Load_ObjectIsItsOwnAncestor_IsRefused()
    {
        _probed.Project.AddYaml("Assets/Arm.prefab", 3, Arm.Replace("PROBE\n", "", StringComparison.Ordinal)
            .Replace("m_Children: []", "m_Children:\n  - {fileID: 2}").Replace("m_Father: {fileID: 0}", "m_Father: {fileID: 12}"));

        Assert.That(() => _probed.Project.Library().Load<GameObject>("Assets/Arm.prefab"),
            Refused(AssetFault.Hierarchy, "Assets/Arm.prefab"));
    }

    [Test]
    public void Load_FileMissingOrNameWrong_ErrorNamesTheFile()
    {
        _probed.Project.Add("Assets/Gone.txt", 4, null).AddYaml("Assets/Misnamed.asset", 5, Scriptable("Other", ""));
        var library = _probed.Project.Library();

        Assert.That(() => library.Load<TextAsset>("Assets/Gone.txt"), Refused(AssetFault.MissingAsset, "Assets/Gone.txt", ".meta"));
        Assert.That(() => library.Load<TextAsset>("Assets/Never.txt"), Refused(AssetFault.MissingAsset, "Assets/Never.txt"));
        Assert.That(() => library.Load<LoaderProbeAsset>("Assets/Misnamed.asset"),
            Refused(AssetFault.Value, "Misnamed.asset &11400000 MonoBehaviour.m_Name", "\"Other\""));
    }

    [Test]
    public void Load_ScriptableObjectOfAnImportedUrdf_IsRefused()
    {
        _probed.Project.Add("Assets/arm.urdf", 4, "<robot/>", "ScriptedImporter");

        Assert.That(() => _probed.Probe("  material: {fileID: 4900000, guid: " + GuidOf(4)
            + ", type: 3}"), Refused(AssetFault.Reference, "LoaderProbe.material", "Assets/arm.urdf"));
    }

    [Test]
    public void Library_TwoMetaFilesWithTheSameGuid_AreRefused()
    {
        _probed.Project.Add("Assets/One.txt", 4, "1").Add("Assets/Two.txt", 4, "2");

        Assert.That(
            () => _probed.Project.Library(), Refused(AssetFault.Duplicate, "Assets/Two.txt.meta", "Assets/One.txt"));
    }
}
