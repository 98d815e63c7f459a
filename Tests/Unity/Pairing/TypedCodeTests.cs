using Nowpose.Messages;
using Nowpose.Pairing;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Pairing.PlayedPairing;

namespace Nowpose.Unity.Tests.Pairing;

/// <summary>Tests codes that are typed or scanned elsewhere, and the file of the paired cells.</summary>
public class TypedCodeTests
{
    static readonly string Bench = new CellCode("bench", "localhost", null, null, 0, 2, 2).Text;

    PlayedPairing _played;

    [SetUp]
    public void Start() => _played = new PlayedPairing();

    [TearDown]
    public void Stop() => _played.Dispose();

    // The next question may appear a second after the answer.
    void Pair(string code)
    {
        _played.Pairing.ReadCode(code);
        _played.Frames();
        _played.Pairing.Accept();
        _played.Frames(70);
    }

    [Test]
    public void ReadCode_KnownCell_IsOfferedAtOnce()
    {
        Pair(Desk);
        Pair(Bench);
        Assert.That(_played.Pairing.Cell, Is.EqualTo("bench"));

        _played.Pairing.ReadCode(Desk);
        _played.Frames();
        Assert.That(_played.Pairing.Question, Does.Contain("'desk'").And.Contain("'bench'"));
        _played.Pairing.Refuse();
        _played.Pairing.Forget();
        _played.Pairing.ReadCode(Desk);
        _played.Frames();
        Assert.That((_played.Pairing.Question, _played.Pairing.Cell), Is.EqualTo(((string)null, "desk")), "no cell is in use");
    }

    // A reader of codes gives the text of each picture in which it finds the code.
    [Test]
    public void ReadCode_RepeatedWhileInView_AsksOnceAndStaysDeclined()
    {
        var asked = 0;
        _played.Pairing.Changed += () => asked += _played.Pairing.Question != null ? 1 : 0;
        void Repeat()
        {
            for (var i = 0; i < 300; i++)
            {
                _played.Pairing.ReadCode(Desk);
                _played.Frames(1);
            }
        }

        _played.Frames();
        Repeat();
        _played.Pairing.Refuse();
        Repeat();

        Assert.That((asked, _played.Pairing.Question), Is.EqualTo((1, (string)null)));
    }

    [TestCase("nowpose:cell/1?n=a")]
    [TestCase("https://example.org/")]
    [TestCase("")]
    public void ReadCode_Invalid_IsReportedEachTime(string text)
    {
        _played.Frames();
        for (var i = 0; i < 2; i++)
        {
            _played.Pairing.ReadCode(text);
            _played.Frames();
            Assert.That(_played.Pairing.Problem, Is.Not.Null);
            _played.Frames(60 * 12);
            Assert.That(_played.Pairing.Problem, Is.Null);
        }
    }

    [Test]
    public void ReadCode_DeclinedGateway_AsksAgain()
    {
        _played.Pairing.ReadCode(Desk);
        _played.Frames();
        _played.Pairing.Refuse();
        _played.Frames(70);

        _played.Pairing.ReadCode(Desk);
        _played.Frames();

        Assert.That(_played.Pairing.Question, Does.Contain("'desk'"));
    }

    // Another program, such as a backup, may use the file at the start. The file is valid.
    [Test]
    public void File_NotReadable_IsKept()
    {
        Pair(Desk);
        var before = File.ReadAllText(_played.FilePath);
        using (new FileStream(_played.FilePath, FileMode.Open, FileAccess.ReadWrite, FileShare.None))
        {
            _played.RestartPlaying();
            Pair(Bench);
            Assert.That(_played.Pairing.Problem, Does.Contain(_played.FilePath).And.Contain("not saved"));
        }

        Assert.That(File.ReadAllText(_played.FilePath), Is.EqualTo(before));
        _played.RestartPlaying();
        _played.Frames();
        Assert.That((_played.Pairing.Cell, _played.Pairing.Problem), Is.EqualTo(("desk", (string)null)));
    }

    CellPairing AddSecond(out MrilSession session)
    {
        session = _played.Cell.NewSession();
        var pairing = session.gameObject.AddComponent<CellPairing>().With("_fileName", _played.FilePath);
        session.gameObject.SetActive(true);
        return pairing;
    }

    void PairSecond(CellPairing pairing, MrilSession session, string code)
    {
        pairing.ReadCode(code);
        _played.Cell.Frame(session);
        pairing.Accept();
        _played.Cell.Frame(session);
    }

    // Objects of a scene that is loaded additively, or kept by DontDestroyOnLoad, are in another scene.
    [TestCase(false)]
    [TestCase(true)]
    public void File_OfTwoPairings_IsSavedByTheFirst(bool isInOtherScene)
    {
        Pair(Desk);
        if (isInOtherScene) World.Current.Scenes.Active = World.Current.Scenes.Add();
        var pairing = AddSecond(out var second);
        Assert.That(second.gameObject.scene == _played.Session.gameObject.scene, Is.Not.EqualTo(isInOtherScene));
        var before = File.ReadAllText(_played.FilePath);

        pairing.ReadCode(Bench);
        _played.Frames();
        pairing.Accept();
        _played.Frames();

        Assert.That(pairing.Problem, Is.EqualTo(PairedCellMessages.Shared(_played.FilePath, _played.Pairing.name)));
        Assert.That(File.ReadAllText(_played.FilePath), Is.EqualTo(before));
        Pair(Press);
        Assert.That(File.ReadAllText(_played.FilePath), Does.Contain("desk").And.Contain("press").And.Not.Contain("bench"));
    }

    [Test]
    public void File_OfTwoPairings_IsSavedByTheSecondOnlyAfterItHasReadTheFileAlone()
    {
        var pairing = AddSecond(out var second);
        Pair(Desk);
        UnityEngine.Object.DestroyImmediate(_played.Session.gameObject);

        PairSecond(pairing, second, Bench);
        Assert.That(pairing.Problem, Is.Not.Null);
        Assert.That(File.ReadAllText(_played.FilePath), Does.Contain("desk").And.Not.Contain("bench"));

        pairing.enabled = false;
        pairing.enabled = true;
        Assert.That(pairing.Problem, Is.Null);
        PairSecond(pairing, second, Bench);
        Assert.That(pairing.Problem, Is.Null);
        Assert.That(File.ReadAllText(_played.FilePath), Does.Contain("desk").And.Contain("bench"));
    }

    [Test]
    public void File_OfTwoPairings_IsStillSavedByTheFirstAfterItWasDisabled()
    {
        var pairing = AddSecond(out var second);
        Pair(Desk);

        _played.Pairing.enabled = false;
        _played.Pairing.enabled = true;
        PairSecond(pairing, second, Bench);

        Assert.That(File.ReadAllText(_played.FilePath), Does.Contain("desk").And.Not.Contain("bench"));
        Pair(Press);
        Assert.That((_played.Pairing.Problem, File.ReadAllText(_played.FilePath).Contains("press")), Is.EqualTo(((string)null, true)));
    }
}
