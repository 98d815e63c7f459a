using System.Text;
using NUnit.Framework;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Recording;

namespace Nowpose.Headless.Tests.Gateway.Recording;

public class LineFileTests
{
    static byte[] Line(string text) => Encoding.UTF8.GetBytes(text + "\n");

    static LineFile Written(SmallDisk disk, params string[] lines)
    {
        var file = new LineFile(disk);
        foreach (var line in lines) file.Write(Line(line));
        return file;
    }

    [Test]
    public void Exists_PathThatCannotBeExamined_IsNotReportedAsDeleted()
    {
        if (OperatingSystem.IsWindows()) Assert.Ignore("symbolic links need a privilege on Windows");
        var folder = Directory.CreateTempSubdirectory("nowpose").FullName;
        File.WriteAllText(Path.Combine(folder, "there"), "");
        Directory.CreateSymbolicLink(Path.Combine(folder, "loop"), "loop");

        Assert.That(LineFile.Exists(Path.Combine(folder, "there")), Is.True);
        Assert.That(LineFile.Exists(Path.Combine(folder, "loop", "session.jsonl")), Is.True);
        Assert.That(LineFile.Exists(Path.Combine(folder, "deleted")), Is.False);
        Assert.That(LineFile.Exists(Path.Combine(folder, "deleted", "session.jsonl")), Is.False);
        Directory.Delete(folder, true);
    }

    [Test]
    public void Flush_DiskAlmostFull_KeepsTheLinesAndFails()
    {
        var disk = new SmallDisk(1000);
        var free = LineFile.ReservedBytes + 100;
        using var file = new LineFile(disk, () => free - disk.Length);
        file.Write(Line("{\"kind\":\"sample\"}"));
        file.Flush();
        file.Write(Line("{\"kind\":\"sample\",\"topic\":\"" + new string('t', 100) + "\"}"));

        Assert.That(file.Flush, Throws.InstanceOf<IOException>().With.Message.EqualTo(RecorderMessages.DiskAlmostFull));
        Assert.That(file.Records, Is.EqualTo(1));
    }

    [Test]
    public void Records_LinesWritten_ExcludesTheRecordersOwnLines()
    {
        using var file = Written(new SmallDisk(1000), "{\"kind\":\"session\"}", "{\"kind\":\"sample\"}", "{\"kind\":\"lost\"}", "{\"kind\":\"sync\"}", "{\"kind\":\"end\"}");

        Assert.That(file.Records, Is.EqualTo(2));
        file.Flush();
        Assert.That(file.Records, Is.EqualTo(2));
    }

    [TestCase(0, 0)]
    [TestCase(9, 0)]
    [TestCase(10, 1)]
    [TestCase(25, 2)]
    public void Flush_DiskFull_KeepsAndCountsCompleteLines(int bytes, int whole)
    {
        var disk = new SmallDisk(bytes);
        var file = Written(disk, "123456789", "123456789", "123456789");

        Assert.That(file.Flush, Throws.InstanceOf<IOException>());

        Assert.That(file.Records, Is.EqualTo(whole));
        Assert.That(disk.Text, Is.EqualTo(string.Concat(Enumerable.Repeat("123456789\n", whole))), "all lines are complete");
        Assert.That(file.Dispose, Throws.Nothing, "Dispose does not write again");
        Assert.That(disk.IsDisposed, Is.True);
    }

    [Test]
    public void Write_LineLongerThanTheBuffer_KeepsTheOrder()
    {
        var disk = new SmallDisk(1_000_000);
        using var file = Written(disk, "first", new string('x', 200_000), "last");
        file.Flush();

        Assert.That(file.Records, Is.EqualTo(3));
        Assert.That(disk.Text, Is.EqualTo("first\n" + new string('x', 200_000) + "\nlast\n"));
    }

    [Test]
    public void Create_FileExists_DoesNotReplaceIt()
    {
        var path = Path.Combine(TestContext.CurrentContext.WorkDirectory, Guid.NewGuid().ToString("N"));
        try
        {
            LineFile.Create(path).Dispose();
            Assert.That(() => LineFile.Create(path), Throws.InstanceOf<IOException>());
            if (!OperatingSystem.IsWindows()) Assert.That((int)File.GetUnixFileMode(path), Is.EqualTo(Convert.ToInt32("640", 8)));
        }
        finally
        {
            File.Delete(path);
        }
    }
}
