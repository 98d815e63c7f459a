using System;
using System.IO;
using Nowpose.Pairing;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Pairing
{
    public class PairedCellsFileTests
    {
        static readonly CertificatePin Pin = CertificatePin.Parse(Convert.ToBase64String(new byte[32]));

        string _folder, _path;

        static CellCode CodeOf(string cell, double x) => new CellCode(cell, "10.0.0.7", Pin, MarkerOffset.Parse(MarkerOffset.Write(x) + ",0,0", ""));

        [SetUp]
        public void Create()
        {
            _folder = Path.Combine(Path.GetTempPath(), "nowpose-" + Guid.NewGuid().ToString("N"));
            _path = Path.Combine(_folder, "paired-cells.json");
        }

        [TearDown]
        public void Remove()
        {
            if (Directory.Exists(_folder)) Directory.Delete(_folder, true);
        }

        [Test]
        public void Load_FileMissing_ReturnsNoCells()
        {
            Assert.That(PairedCellsFile.Load(_path, out var problem, out _), Is.SameAs(PairedCells.None));
            Assert.That(problem, Is.Null);
        }

        [Test]
        public void Load_SavedCells_RoundTrip()
        {
            var first = new PairedCell(new[] { CodeOf("Prüfzelle 3", 0), CodeOf("Prüfzelle 3", 1) }, "to\"ken");
            var cells = PairedCells.None.Use(first).Use(new PairedCell(new[] { CodeOf("b", 0) }, null)).Use(first);

            PairedCellsFile.Save(_path, cells);
            PairedCellsFile.Save(_path, cells);
            var loaded = PairedCellsFile.Load(_path, out var problem, out _);

            Assert.That(problem, Is.Null);
            Assert.That(loaded.Used.Cell, Is.EqualTo("Prüfzelle 3"));
            Assert.That(loaded.Used.Token, Is.EqualTo("to\"ken"));
            Assert.That(loaded.Used.Codes.Count, Is.EqualTo(2));
            Assert.That(loaded.Find("b").Token, Is.Null);
            Assert.That(Directory.GetFiles(_folder).Length, Is.EqualTo(1), "no temporary file remains");
        }

        [TestCase("")]
        [TestCase("{\"format\":\"nowpose-paired-cells\",\"version\":1,\"cells\":[{\"codes\":[\"nowpose:cell/1?n=a&h=localhost\"")]
        [TestCase("{\"format\":\"other\",\"version\":1,\"cells\":[]}")]
        [TestCase("{\"format\":\"nowpose-paired-cells\",\"version\":2,\"cells\":[]}")]
        [TestCase("{\"format\":\"nowpose-paired-cells\",\"cells\":[]}")]
        [TestCase("{\"format\":\"nowpose-paired-cells\",\"version\":1,\"used\":\"a\",\"cells\":[]}")]
        [TestCase("{\"format\":\"nowpose-paired-cells\",\"version\":1,\"cells\":[{\"codes\":[]}]}")]
        [TestCase("{\"format\":\"nowpose-paired-cells\",\"version\":1,\"cells\":[{\"codes\":[\"nowpose:cell/1?n=a&h=::1\","
            + "\"nowpose:cell/1?n=a&h=::1\"]}]}")]
        [TestCase("{\"format\":\"nowpose-paired-cells\",\"version\":1,\"cells\":[{\"codes\":[\"nowpose:cell/1?n=a\"]}]}")]
        [TestCase("{\"format\":\"nowpose-paired-cells\",\"version\":1,\"cells\":[{\"codes\":[\"nowpose:cell/1?n=a&h=::1\"],\"token\":\"a b\"}]}")]
        public void Load_InvalidFile_IsReportedAndRenamed(string text)
        {
            Directory.CreateDirectory(_folder);
            File.WriteAllText(_path, text);

            Assert.That(PairedCellsFile.Load(_path, out var problem, out _), Is.SameAs(PairedCells.None));

            Assert.That(problem, Does.StartWith(_path + ": ").And.Contain(_path + ".bad").And.Not.Contain("\n"));
            Assert.That(File.ReadAllText(_path + ".bad"), Is.EqualTo(text));
            Assert.That(File.Exists(_path), Is.False);
        }

        [Test]
        public void Use_MoreThanTheMaximum_DropsTheOldest()
        {
            var cells = PairedCells.None;
            for (var i = 0; i <= PairedCells.MaxCount; i++) cells = cells.Use(new PairedCell(new[] { CodeOf("c" + i, 0) }, null));

            Assert.That(cells.All.Count, Is.EqualTo(PairedCells.MaxCount));
            Assert.That(cells.Find("c0"), Is.Null);
            Assert.That(cells.Used.Cell, Is.EqualTo("c" + PairedCells.MaxCount));
        }

        [Test]
        public void With_MoreMarkersThanTheMaximum_IsRefused()
        {
            var cell = new PairedCell(new[] { CodeOf("a", 0) }, null);
            for (var i = 1; i < PairedCell.MaxCodes; i++) cell = cell.With(CodeOf("a", i));

            Assert.That(cell.IsFull, Is.True);
            Assert.That(cell.Holds(CodeOf("a", 0)), Is.True);
            Assert.That(() => cell.With(CodeOf("a", 16)), Throws.TypeOf<InputException>());
        }
    }
}
