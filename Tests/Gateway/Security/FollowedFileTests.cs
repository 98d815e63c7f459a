using Nowpose.Gateway.Security;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Security;

public class FollowedFileTests
{
    readonly List<string> _log = [];
    string _path;

    [SetUp]
    public void SetUp()
    {
        _log.Clear();
        _path = Path.GetTempFileName();
        File.WriteAllText(_path, "first");
    }

    [TearDown]
    public void TearDown() => File.Delete(_path);

    [Test]
    public void File_UnusableForAWhile_KeepsTheFormerContentAndLogsTheReason()
    {
        var file = new FollowedFile<string>(
            [_path],
            (out string part) =>
            {
                part = null;
                return File.ReadAllText(_path) is "first" and var text ? text : throw new IOException("not valid yet");
            },
            TimeSpan.Zero, _log.Add);
        File.WriteAllText(_path, "a later text");

        Assert.That(file.Current, Is.EqualTo("first"));
        Assert.That(_log, Has.Exactly(1).Contains("not valid yet"));
    }

    /// <summary>An editor truncates the file before it writes the new text. The incomplete text must be neither used nor reported.</summary>
    [TestCase("")]
    [TestCase("half a ", "the file ends too early")]
    public void File_WrittenDuringRead_IsReadAgain(string meanwhile, string fault = null)
    {
        var isBeingWritten = false;
        var used = new List<string>();
        var file = new FollowedFile<string>([_path], (out string part) =>
        {
            part = null;
            var text = File.ReadAllText(_path);
            if (!isBeingWritten) return text;
            isBeingWritten = false;
            File.WriteAllText(_path, "the whole second text");
            return fault == null ? text : throw new InputException(fault);
        }, TimeSpan.Zero, _log.Add, (former, now) => used.Add($"{now} after {former}"));
        File.WriteAllText(_path, meanwhile);
        isBeingWritten = true;

        Assert.That(file.Current, Is.EqualTo("first"), "the file was read while it was written");
        Assert.That(file.Current, Is.EqualTo("the whole second text"));
        Assert.That(_log, Is.Empty);
        Assert.That(used, Is.EqualTo(new[] { "the whole second text after first" }));
    }
}
