using Nowpose.Web;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Web;

public sealed class NodeProgramTests
{
    string _folder;

    [SetUp]
    public void SetUp() => _folder = Directory.CreateTempSubdirectory("nowpose-node-").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(_folder, true);

    [Test]
    public void In_FolderWithoutNode_ReturnsTheInstalledNode() => Assert.That(NodeProgram.In(_folder), Is.EqualTo("node"));

    [Test]
    public void In_FolderOfARelease_ReturnsTheIncludedNode()
    {
        var program = Path.Combine(_folder, "node", OperatingSystem.IsWindows() ? "node.exe" : "node");
        Directory.CreateDirectory(Path.GetDirectoryName(program));
        File.WriteAllText(program, "");

        Assert.That(NodeProgram.In(_folder), Is.EqualTo(program));
    }

    [Test]
    public void Start_ScriptMissing_StatesTheReasonAndASuggestion() => Assert.That(
        () => NodeProgram.Start("Node.js is needed", Path.Combine(_folder, "script.mjs"), []),
        Throws.InstanceOf<InputException>().With.Message.StartsWith("Node.js is needed; ").And.Message.Contains("build again"));
}
