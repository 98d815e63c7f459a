using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Unity;
using UnityEngine;

namespace Nowpose.Unity.Tests.Status;

/// <summary>A status panel below a running session, and the text that it shows.</summary>
sealed class PlayedPanel : IDisposable
{
    static readonly TimeSpan RenderTime = TimeSpan.FromMilliseconds(9.5);

    int _frames;

    public PlayedPanel()
    {
        Cell = new PlayedCell();
        Session = Cell.NewSession("ur5", new SessionSettings(
            new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40),
            range: new ConstantLatencyRange(15, RenderTimeSourceKind.DisplayGpuTime)));
        Camera = new GameObject("Camera") { tag = "MainCamera" }.AddComponent<Camera>();
        var panel = new GameObject("Status Panel");
        panel.transform.SetParent(Session.gameObject.transform);
        panel.transform.position = new Vector3(0, 0, 2);
        var cell = new GameObject("Cell").AddComponent<TextMesh>();
        cell.fontSize = 64;
        cell.transform.SetParent(panel.transform, false);
        Panel = panel.AddComponent<StatusPanel>().With("_cell", cell);
        EachFrame = _ => Session.Session?.Rendered(RenderTime, RenderTimeSourceKind.DisplayGpuTime);
    }

    public PlayedCell Cell { get; }
    public MrilSession Session { get; }
    public Action<int> EachFrame { get; set; }
    public StatusPanel Panel { get; }
    public Camera Camera { get; }

    public void Play(double seconds)
    {
        Session.gameObject.SetActive(true);
        Run(seconds);
    }

    public void Run(double seconds) => Cell.Run(seconds, Session, () => EachFrame?.Invoke(_frames++));

    public Transform Sheet => Panel.transform.Find("Cells");

    public TextMesh[] Texts => Sheet.GetComponentsInChildren<TextMesh>();

    /// <summary>Returns the value and the note in the row of a label.</summary>
    public (string Value, string Note) Row(string label)
    {
        var row = Texts.Single(t => t.text == label).name.Split(' ')[0];
        return (Text(row + " 1"), Text(row + " 2"));
    }

    public string Text(string cell) => Sheet.Find(cell).GetComponent<TextMesh>().text;

    public void Dispose() => Cell.Dispose();
}
