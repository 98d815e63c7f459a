using Nowpose.Pairing;
using Nowpose.Protocol;
using Nowpose.Unity;
using UnityEngine;

namespace Nowpose.Unity.Tests.Pairing;

/// <summary>
/// A running session with the pairing component, a base anchor and codes in view. Its connections fail, because their port is closed.
/// </summary>
sealed class PlayedPairing : IDisposable
{
    static readonly CertificatePin Pin = CertificatePin.Parse(Convert.ToBase64String(new byte[32]));

    // These codes name port 1, which is closed.
    public static readonly string Desk = new CellCode("desk", "127.0.0.1", null, MarkerOffset.Parse("0.5,0,0", ""), 0.1, 1, 1).Text;

    public static readonly string Press = new CellCode("press", "127.0.0.1", Pin, MarkerOffset.Parse("0.5,0,0", ""), 0.1, 1, 1).Text;

    readonly string _folder;

    public PlayedPairing()
    {
        _folder = Directory.CreateTempSubdirectory("nowpose-pairing-").FullName;
        Cell = new PlayedCell();
        Play();
    }

    public PlayedCell Cell { get; }
    public MrilSession Session { get; private set; }
    public CellPairing Pairing { get; private set; }
    public BaseAnchor Anchor { get; private set; }
    public ShownCodes Shown { get; private set; }

    public string FilePath => Path.Combine(_folder, "cells.json");

    public void RestartPlaying()
    {
        UnityEngine.Object.Destroy(Session.gameObject);
        Cell.Frame(null);
        Play();
    }

    public void Frames(int count = 2)
    {
        for (var i = 0; i < count; i++)
        {
            Shown.Seen = Cell.Clock.Now;
            Cell.Frame(Session);
        }
    }

    public void Dispose()
    {
        Cell.Dispose();
        Directory.Delete(_folder, true);
    }

    void Play()
    {
        Session = Cell.NewSession();
        Pairing = Session.gameObject.AddComponent<CellPairing>().With("_fileName", FilePath);
        Anchor = new GameObject("Base").AddComponent<BaseAnchor>();
        Anchor.transform.SetParent(Session.transform, false);
        Shown = ShownCodes.Below(Session);
        Session.gameObject.SetActive(true);
    }
}
