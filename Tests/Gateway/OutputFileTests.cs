using System.Diagnostics;
using Nowpose.Gateway;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway;

public sealed class OutputFileTests
{
    static readonly PairedHeadset First = new("first", new DateTime(2026, 11, 20, 12, 0, 0, DateTimeKind.Utc), TokenList.HashOf("a"));
    static readonly PairedHeadset Second = First with { Name = "second", Hash = TokenList.HashOf("b") };

    TemporaryFolder _folder;

    [SetUp]
    public void SetUp() => _folder = new TemporaryFolder();

    [TearDown]
    public void TearDown() => _folder.Dispose();

    [TestCase("old")]
    [TestCase(null)]
    public void Write_FailureInTheMiddle_KeepsTheFolderAsItWas(string earlier)
    {
        var path = At("page.html");
        if (earlier != null) File.WriteAllText(path, earlier);

        Assert.Throws<IOException>(() => OutputFile.Write(path, (TextWriter file) =>
        {
            file.Write("half");
            file.Flush();
            throw new IOException();
        }));

        Assert.That(Directory.GetFiles(_folder.Path).Select(File.ReadAllText), Is.EqualTo(earlier == null ? [] : new[] { earlier }));
    }

    [Test]
    public void Write_ExistingFile_IsReplacedWithoutBeingChanged()
    {
        var path = At("page.html");
        File.WriteAllText(path, "old");
        using var reader = new StreamReader(new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete));

        OutputFile.Write(path, "new");

        Assert.That(reader.ReadToEnd(), Is.EqualTo("old"));
        Assert.That(Directory.GetFiles(_folder.Path).Select(File.ReadAllText), Is.EqualTo(new[] { "new" }));
    }

    [Test]
    [Platform(Exclude = "Win")]
    public void Write_SymbolicLink_ReplacesItsTargetAndKeepsTheMode()
    {
        const UnixFileMode mode = UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.GroupRead | UnixFileMode.GroupWrite;
        File.WriteAllText(At("target"), "old");
        File.SetUnixFileMode(At("target"), mode);
        File.CreateSymbolicLink(At("link"), "target");

        OutputFile.Write(At("link"), "new");

        Assert.That(new FileInfo(At("link")).LinkTarget, Is.EqualTo("target"));
        Assert.That((File.ReadAllText(At("target")), File.GetUnixFileMode(At("target"))), Is.EqualTo(("new", mode)));
    }

    [Test]
    [Platform(Exclude = "Win")]
    public void Write_SymbolicLinkWithoutATarget_CreatesTheTarget()
    {
        File.CreateSymbolicLink(At("link"), "target");

        OutputFile.Write(At("link"), "new");

        Assert.That((new FileInfo(At("link")).LinkTarget, File.ReadAllText(At("target"))), Is.EqualTo(("target", "new")));
    }

    [Test]
    [Platform(Exclude = "Win")]
    public void TargetOf_NameOfALinkInTheCurrentFolder_IsInTheCurrentFolder()
    {
        var link = Path.GetRandomFileName();
        File.CreateSymbolicLink(link, link + ".target");
        try
        {
            Assert.That(OutputFile.TargetOf(link), Is.EqualTo(Path.Combine(Environment.CurrentDirectory, link + ".target")));
        }
        finally
        {
            File.Delete(link);
        }
    }

    [Test]
    [Platform(Exclude = "Win")]
    public void TargetOf_LinkBelowALinkedFolder_IsRelativeToTheTrueFolder()
    {
        Directory.CreateDirectory(At("folder/real"));
        File.CreateSymbolicLink(At("alias"), At("folder/real"));
        File.CreateSymbolicLink(At("folder/real/link"), "../target");

        Assert.That(OutputFile.TargetOf(At("alias/link")), Is.EqualTo(At("folder/target")));
    }

    [Test]
    [Platform(Exclude = "Win")]
    public void TargetOf_LoopOfLinks_Fails()
    {
        File.CreateSymbolicLink(At("a"), "b");
        File.CreateSymbolicLink(At("b"), "a");

        Assert.Throws<IOException>(() => OutputFile.TargetOf(At("a")));
    }

    [Test]
    [Platform("Linux")]
    public void Write_LinkToADevice_WritesToTheDevice()
    {
        File.CreateSymbolicLink(At("link"), "/dev/null");

        OutputFile.Write(At("link"), "new");

        Assert.That((new FileInfo(At("link")).LinkTarget, File.ReadAllText("/dev/null")), Is.EqualTo(("/dev/null", "")));
    }

    // Files below /dev/shm are ordinary files in memory, not devices.
    [Test]
    [Platform(Include = "Linux")]
    public void Write_BelowDevShm_CreatesAndReplacesTheFile()
    {
        var path = Path.Combine("/dev/shm", Path.GetRandomFileName());
        try
        {
            OutputFile.Write(path, "longer text");
            Assert.That(File.ReadAllText(path), Is.EqualTo("longer text"));

            OutputFile.Write(path, "text");
            Assert.That(File.ReadAllText(path), Is.EqualTo("text"));
        }
        finally
        {
            File.Delete(path);
        }
    }

    [Test]
    public void CreateSecret_ExistingFile_KeepsIt()
    {
        File.WriteAllText(At("key"), "old");

        Assert.Throws<IOException>(() => OutputFile.CreateSecret(At("key"), [1]));

        Assert.That(Directory.GetFiles(_folder.Path).Select(File.ReadAllText), Is.EqualTo(new[] { "old" }));
    }

    [Test]
    public void HeadsetFile_RemovalFails_KeepsAllHeadsets()
    {
        Fill();
        Directory.CreateDirectory(At("headsets.txt.new"));

        Assert.Throws<InputException>(() => HeadsetFile.Remove(At("headsets.txt"), [First]));

        Assert.That(HeadsetFile.Load(At("headsets.txt")).Select(headset => headset.Name), Is.EqualTo(new[] { First.Name, Second.Name }));
    }

    [Test]
    [Platform("Linux")]
    public async Task HeadsetFile_ChangedByAPrivilegedProcess_KeepsTheOwner()
    {
        if (!Environment.IsPrivilegedProcess) Assert.Ignore("only root can give files away");
        Fill();
        await RunAsync("chown", "123:456", At("headsets.txt"));

        HeadsetFile.Remove(At("headsets.txt"), [First]);

        Assert.That(await RunAsync("stat", "-c", "%u:%g %a", At("headsets.txt")), Is.EqualTo("123:456 600\n"));
        Assert.That(HeadsetFile.Load(At("headsets.txt")), Has.Count.EqualTo(1));
    }

    string At(string name) => Path.Combine(_folder.Path, name);

    void Fill()
    {
        HeadsetFile.Open(At("headsets.txt"));
        HeadsetFile.Add(At("headsets.txt"), First);
        HeadsetFile.Add(At("headsets.txt"), Second);
    }

    static async Task<string> RunAsync(string program, params string[] arguments)
    {
        using var process = Process.Start(new ProcessStartInfo(program, arguments) { RedirectStandardOutput = true });
        await process.WaitForExitAsync().Bounded();
        return await process.StandardOutput.ReadToEndAsync().Bounded();
    }
}
