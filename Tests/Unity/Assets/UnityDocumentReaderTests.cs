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

    [TestCase("", AssetFault.Header, "Arm.prefab: ")]
    [TestCase("--- !u!1 &1\nGameObject:\n  m_Name: A\n", AssetFault.Header, "Arm.prefab: ")]
    [TestCase(Header, AssetFault.NoObject, "Arm.prefab: ")]
    [TestCase(Header + "x: 1\n--- !u!1 &1\nGameObject:\n  m_Name: A\n", AssetFault.Header, "Arm.prefab: ")]
    [TestCase(Header + "--- !u!1 &1\nGameObject:\n  m_Name: A\n--- !u!4 &1\nTransform:\n  a: 1\n", AssetFault.Duplicate, "Arm.prefab &1: ")]
    [TestCase(Header + "--- !u!1 &0\nGameObject:\n  m_Name: A\n", AssetFault.FileId, "&0: ")]
    [TestCase(Header + "--- !u!1 &99999999999999999999\nGameObject:\n  m_Name: A\n", AssetFault.FileId, "&99999999999999999999: ")]
    [TestCase(Header + "--- !u!1 &1\nGameObject:\n  m_Name: A\n--- !u!4\nTransform:\n  a: 1\n", AssetFault.Header, "Arm.prefab line 6: ")]
    [TestCase(Header + "--- !u!1 &1\nGameObject:\n  m_Name: A\n  m_Name: B\n", AssetFault.Syntax, "Arm.prefab &1 line 6: ")]
    [TestCase(Header + "--- !u!1 &1\nGameObject:\n  m_Name: {a: 1\n", AssetFault.Syntax, "Arm.prefab &1 line ")]
    [TestCase(Header + "--- !u!1 &1\nGameObject:\n", AssetFault.ClassCount, "&1: ")]
    [TestCase(Header + "--- !u!1 &1\nGameObject:\n  a: 1\nTransform:\n  b: 2\n", AssetFault.ClassCount, "&1: ")]
    [TestCase(Header + "--- !u!1 &1\n", AssetFault.ClassCount, "&1: ")]
    public void Read_InvalidFile_ThrowsWithThePlaceInTheFile(string text, object fault, string place)
    {
        Assert.That(() => UnityDocumentReader.Read(text, "Arm.prefab"),
            Throws.TypeOf<AssetException>().With.Property(nameof(AssetException.Fault)).EqualTo(fault).And.Message.Contains(place));
    }

    static IReadOnlyList<UnityDocument> Read(string body) => UnityDocumentReader.Read(Header + body, "x");
}
