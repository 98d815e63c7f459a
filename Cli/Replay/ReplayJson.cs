namespace Nowpose.Cli.Replay;

/// <summary>Formats the result of a replay as JSON, with all digits of the numbers.</summary>
static class ReplayJson
{
    /// <param name="notes">Reasons why the result can mislead a reader; empty if there are none.</param>
    /// <param name="conditions">The conditions of the result.</param>
    public static string Of(ReplayResult result, IReadOnlyCollection<string> notes, object conditions)
    {
        var json = new Dictionary<string, object>
        {
            ["file"] = result.File, ["predictor"] = result.Predictor, ["frames"] = result.Frames, ["axes"] = result.Axes.Select(Axis),
            ["rms_hold"] = result.RmsHold, ["rms"] = result.Rms, ["reduction"] = result.Reduction,
            ["conditions"] = conditions,
        };
        if (result.Totals.Count > 0) json["totals"] = result.Totals;
        if (result.Passes.Count > 1) json["passes"] = result.Passes;
        if (result.Bodies.Count > 0) json["bodies"] = result.Bodies.Select(body => new
        {
            Name = body.File, body.Frames, ErrorMm = Error(body.Position), ErrorDeg = Error(body.Rotation),
            DisplayedErrorMm = Error(body.Displayed?.Position), DisplayedErrorDeg = Error(body.Displayed?.Rotation),
        });
        if (result.Signals.Count > 0) json["signals"] = result.Signals.Select(signal => new { signal.Name, signal.Changes });
        if (notes.Count > 0) json["notes"] = notes;
        return JsonText.Of(json);
    }

    /// <summary>Formats the result of a rigid body. It has no totals, because millimetres and degrees cannot be added.</summary>
    /// <inheritdoc cref="Of(ReplayResult, IReadOnlyCollection{string}, object)" path="/param"/>
    public static string Of(BodyReplayResult result, IReadOnlyCollection<string> notes, object conditions)
    {
        var json = new Dictionary<string, object>
        {
            ["file"] = result.File, ["predictor"] = result.Predictor, ["frames"] = result.Frames,
            ["body"] = new { ErrorMm = Error(result.Position), ErrorDeg = Error(result.Rotation) }, ["conditions"] = conditions,
        };
        if (result.Passes.Count > 1) json["passes"] = result.Passes;
        if (notes.Count > 0) json["notes"] = notes;
        return JsonText.Of(json);
    }

    static object Error(ErrorComparison? comparison) => comparison is { } error ? new { error.RmsHold, error.Rms, error.P95 } : null;

    static Dictionary<string, object> Axis(ReplayResult.Axis axis)
    {
        var json = new Dictionary<string, object>
        {
            ["name"] = axis.Name, ["rms_hold"] = axis.Error.RmsHold, ["rms"] = axis.Error.Rms, ["p95"] = axis.Error.P95, ["max"] = axis.Error.Max,
        };
        if (axis.Unit != null) json["unit"] = axis.Unit;
        if (axis.Deviation is not { } deviation) return json;
        (json["sd"], json["inside_1sd"], json["inside_2sd"]) = (deviation.Mean, deviation.All.InsideOne, deviation.All.InsideTwo);
        (json["sd_rms"], json["sd_frames"], json["moving_frames"]) = (deviation.Rms, deviation.All.Frames, deviation.Moving.Frames);
        (json["moving_inside_1sd"], json["moving_inside_2sd"]) = (deviation.Moving.InsideOne, deviation.Moving.InsideTwo);
        return json;
    }
}
