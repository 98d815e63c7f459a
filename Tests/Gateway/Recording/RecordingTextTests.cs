using System.IO.Compression;
using System.Text;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.MotionRecordings;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Recording;

public class RecordingTextTests
{
    string _path;

    [SetUp]
    public void SetUp() => _path = Path.Combine(Path.GetTempPath(), $"nowpose-{Guid.NewGuid():N}.csv.gz");

    [TearDown]
    public void TearDown() => File.Delete(_path);

    [TestCase('x')]
    [TestCase(' ')]
    public void Read_LineOfManyMegabytes_ThrowsBeforeItIsRead(char filler)
    {
        Write("t,a\n0,1\n1,", new string(filler, 32 * 1024 * 1024), "\n");

        var fault = Assert.Throws<InputException>(() => MotionRecording.Read(_path));

        Assert.That(fault.Message, Does.StartWith($"{_path}:3: ").And.Contains("8 MiB"));
    }

    [Test]
    public void Read_QuotedFieldOfManyLines_Throws()
    {
        Write("t,a\n0,\"", string.Concat(Enumerable.Repeat("1234567\n", 4 * 1024 * 1024)), "\"\n");

        Assert.That(() => MotionRecording.Read(_path), Throws.InstanceOf<InputException>().With.Message.Contains("8 MiB"));
    }

    [Test]
    public void Open_FileInUse_NamesThatAsTheReason()
    {
        using var other = new FileStream(_path, FileMode.Create, FileAccess.Write, FileShare.None);

        var fault = Assert.Throws<InputException>(() => RecordingText.Open(_path).Dispose());

        Assert.That(fault.Message, Does.EndWith(PathMessages.CloseElsewhere));
    }

    void Write(params string[] parts)
    {
        using var file = new StreamWriter(new GZipStream(File.Create(_path), CompressionLevel.Fastest), Encoding.ASCII);
        foreach (var part in parts) file.Write(part);
    }
}
