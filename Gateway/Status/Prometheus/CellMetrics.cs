using Nowpose.Gateway.Status.Cell;

namespace Nowpose.Gateway.Status.Prometheus;

/// <summary>Writes the metrics of the state of each frame and signal.</summary>
/// <remarks>
/// The number of label values is bounded: the states are fixed sets, the published frames and signals are limited where they are received, and those
/// that adapters only report are limited here.
/// </remarks>
static class CellMetrics
{
    // Maximum number of frames or signals that are reported but not published.
    const int MaxReported = ProtocolLimits.Frames;

    public static void Add(PrometheusText text, StatusSnapshot state)
    {
        Add(
            text, "nowpose_frame_state", "1 for the present state of the frame, 0 for the other states.", "frame", CellStates.OfFrames,
            [.. state.Frames.Select(frame => (frame.Name, frame.Source, frame.State, frame.Parent != null))]);
        Add(
            text, "nowpose_signal_state", "1 for the present state of the signal, 0 for the other states.", "signal", CellStates.OfSignals,
            [.. state.Signals.Select(signal => (signal.Name, signal.Source, signal.State, signal.Value != null))]);
    }

    static void Add(
        PrometheusText text, string metric, string help, string kind, IReadOnlyList<string> states,
        (string Name, string Source, string State, bool IsPublished)[] all)
    {
        var listed = all.Where(one => one.IsPublished).Concat(all.Where(one => !one.IsPublished).Take(MaxReported)).ToList();
        text.States(metric, help, listed, one => [(kind, one.Name), ("source", one.Source)], one => one.State, states);
    }
}
