using System;
using System.IO;
using System.Text.RegularExpressions;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Messages;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency.Profile
{
    public class LatencyProfileFileTests
    {
        string _folder, _path;

        [SetUp]
        public void MakeFolder()
        {
            _folder = Path.Combine(Path.GetTempPath(), "nowpose-profile-" + Guid.NewGuid().ToString("N"));
            _path = Path.Combine(_folder, "profile.json");
        }

        [TearDown]
        public void RemoveFolder()
        {
            if (Directory.Exists(_folder)) Directory.Delete(_folder, true);
        }

        static LatencyProfile Profile(double visuMs) =>
            new LatencyProfile(visuMs, 1, "HoloLens 2", 60, new DateTime(2026, 11, 20, 0, 0, 0, DateTimeKind.Utc), CalibrationMethod.Sine, 3);

        static string Half(string text) => text.Substring(0, text.Length / 2);

        double LoadedMs() => LatencyProfileFile.Load(_path).Visualisation.Length.TotalMilliseconds;

        [Test]
        public void Save_NewAndExistingFile_LeavesOnlyTheSavedProfile()
        {
            LatencyProfileFile.Save(_path, Profile(40));
            var first = LoadedMs();

            LatencyProfileFile.Save(_path, Profile(50));

            Assert.That(first, Is.EqualTo(40));
            Assert.That(LoadedMs(), Is.EqualTo(50));
            Assert.That(Directory.GetFiles(_folder), Is.EqualTo(new[] { _path }));
        }

        [Test]
        public void Load_SaveInterruptedBeforeReplacing_ReturnsThePreviousProfile()
        {
            LatencyProfileFile.Save(_path, Profile(40));
            File.WriteAllText(_path + ".new", Half(LatencyProfileJson.Write(Profile(50))));
            var afterwards = LoadedMs();

            LatencyProfileFile.Save(_path, Profile(60));

            Assert.That(afterwards, Is.EqualTo(40));
            Assert.That(LoadedMs(), Is.EqualTo(60), "the remaining temporary file does not prevent saving");
        }

        [Test]
        public void Save_CannotWrite_ThrowsAndKeepsThePreviousProfile()
        {
            LatencyProfileFile.Save(_path, Profile(40));
            Directory.CreateDirectory(_path + ".new");

            var fault = Assert.Throws<InputException>(() => LatencyProfileFile.Save(_path, Profile(50)));

            Assert.That(fault.Message, Does.Match("^" + FileMessages.NotSaved(Regex.Escape(_path), "latency profile", ".+") + "$"));
            Assert.That(LoadedMs(), Is.EqualTo(40));
        }

        [Test]
        public void Load_FileMissing_ThrowsWithAOneLineMessage()
        {
            var fault = Assert.Throws<InputException>(() => LatencyProfileFile.Load(_path));

            Assert.That(fault.Message, Does.Match("^" + FileMessages.NotRead(Regex.Escape(_path), ".+") + "$"));
        }

        [Test]
        public void Load_TruncatedFile_NamesTheFile()
        {
            LatencyProfileFile.Save(_path, Profile(40));
            File.WriteAllText(_path, Half(File.ReadAllText(_path)));

            Assert.That(Assert.Throws<InputException>(() => LatencyProfileFile.Load(_path)).Message,
                Is.EqualTo(_path + ": " + ProfileMessages.NotComplete));
        }

        [Test]
        public void Load_HugeFile_IsRefusedWithoutReading()
        {
            Directory.CreateDirectory(_folder);
            File.WriteAllBytes(_path, new byte[1_000_000]);

            Assert.That(Assert.Throws<InputException>(() => LatencyProfileFile.Load(_path)).Message,
                Is.EqualTo(FileMessages.TooLong(_path, 1_000_000, 65536)));
        }
    }
}
