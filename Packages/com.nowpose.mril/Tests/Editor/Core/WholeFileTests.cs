using System;
using System.IO;
using NUnit.Framework;

namespace Nowpose.Tests.Core
{
    public class WholeFileTests
    {
        string _folder, _path;

        [SetUp]
        public void MakeFolder()
        {
            _folder = Path.Combine(Path.GetTempPath(), "nowpose-files-" + Guid.NewGuid().ToString("N"));
            _path = Path.Combine(_folder, "file.txt");
            Directory.CreateDirectory(_folder);
        }

        [TearDown]
        public void RemoveFolder() => Directory.Delete(_folder, true);

        // On Windows, a replacement that fails can remove the file. A folder with the name of the file makes each renaming fail here.
        [TestCase(true, TestName = "Write_FileIsRemovedAndRenamingFails_KeepsTheTemporaryFile")]
        [TestCase(false, TestName = "Write_RenamingOfANewFileFails_LeavesNoTemporaryFile")]
        public void Write_RenamingFails_KeepsTheOnlyCopy(bool exists)
        {
            if (exists) File.WriteAllText(_path, "old");

            Assert.That(() => WholeFile.Write(_path, Fill), Throws.InstanceOf<IOException>());

            Assert.That(File.Exists(_path + ".new"), Is.EqualTo(exists));
        }

        void Fill(Stream file)
        {
            file.WriteByte((byte)'n');
            File.Delete(_path);
            Directory.CreateDirectory(_path);
        }
    }
}
