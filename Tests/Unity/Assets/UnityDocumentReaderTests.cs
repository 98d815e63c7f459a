using Nowpose.UnityPlayer.Assets;
using Nowpose.UnityPlayer.Assets.Yaml;
using NUnit.Framework;
using YamlDotNet.RepresentationModel;

namespace Nowpose.Unity.Tests.Assets;

public sealed class UnityDocumentReaderTests
{
    const string Header = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";

    [Test]
    public void Read_TwoObjects_ReturnsClassesIdsAndFields()
    {
        var documents = Read("--- !u!1 &-7\nGameObject:\n  m_Name: Arm\n--- !u!4 &8 stripped\nTransform:\n  m_PrefabInstance: {fileID: 9}\n");

        Assert.That(documents.Select(d => (d.ClassId, d.ClassName, d.FileId, d.IsStripped)),
            Is.EqualTo(new[] { (1, "GameObject", -7L, false), (4, "Transform", 8L, true) }));
        Assert.That(((YamlScalarNode)Nodes.Find(documents[0].Fields, "m_Name")).Value, Is.EqualTo("Arm"));
    }

    [Test]
    public void Read_LinesEndWithCrLf_ReturnsTheSameObjects()
    {
        var text = (Header + "--- !u!1 &7\nGameObject:\n  m_Name: Arm\n").Replace("\n", "\r\n", StringComparison.Ordinal);

        Assert.That(UnityDocumentReader.Read(text, "x").Single().FileId, Is.EqualTo(7));
    }

    [TestCase("", "Arm.prefab: does not begin with the two header lines")]
    [TestCase("--- !u!1 &1\nGameObject:\n  m_Name: A\n", "Arm.prefab: does not begin with the two header lines")]
    [TestCase(Header, "Arm.prefab: contains no object")]
    [TestCase(Header + "x: 1\n--- !u!1 &1\nGameObject:\n  m_Name: A\n", "text before the first object")]
    [TestCase(Header + "--- !u!1 &1\nGameObject:\n  m_Name: A\n--- !u!4 &1\nTransform:\n  a: 1\n", "Arm.prefab &1: this fileID occurs twice")]
    [TestCase(Header + "--- !u!1 &0\nGameObject:\n  m_Name: A\n", "&0: not a fileID")]
    [TestCase(Header + "--- !u!1 &99999999999999999999\nGameObject:\n  m_Name: A\n", "not a fileID")]
    [TestCase(Header + "--- !u!1 &1\nGameObject:\n  m_Name: A\n--- !u!4\nTransform:\n  a: 1\n", "Arm.prefab line 6: not the header of an object")]
    [TestCase(Header + "--- !u!1 &1\nGameObject:\n  m_Name: A\n  m_Name: B\n", "Arm.prefab &1 line 6")]
    [TestCase(Header + "--- !u!1 &1\nGameObject:\n  m_Name: {a: 1\n", "Arm.prefab &1 line")]
    [TestCase(Header + "--- !u!1 &1\nGameObject:\n", "&1: must contain one class name with its fields")]
    [TestCase(Header + "--- !u!1 &1\nGameObject:\n  a: 1\nTransform:\n  b: 2\n", "&1: must contain one class name with its fields")]
    [TestCase(Header + "--- !u!1 &1\n", "&1: must contain one class name with its fields")]
    public void Read_InvalidFile_ThrowsWithThePlaceInTheFile(string text, string expected)
    {
        Assert.That(() => UnityDocumentReader.Read(text, "Arm.prefab"), Throws.TypeOf<AssetException>().With.Message.Contains(expected));
    }

    static IReadOnlyList<UnityDocument> Read(string body) => UnityDocumentReader.Read(Header + body, "x");
}
