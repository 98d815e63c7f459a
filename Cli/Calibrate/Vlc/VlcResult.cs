namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>The evaluation of all pictures, in their original order.</summary>
sealed class VlcResult(IReadOnlyList<PictureResult> pictures)
{
    public IReadOnlyList<PictureResult> Pictures { get; } = pictures;

    public IReadOnlyList<PictureResult> Read { get; } = [.. pictures.Where(picture => picture.IsRead)];

    public int Rejected => Pictures.Count - Read.Count;

    /// <summary>Mean L_visu of the pictures near the median, ms; null if no picture was read.</summary>
    public double? Mean => Near?.VisuMs;

    /// <summary>Standard deviation of L_visu of the pictures near the median, ms; null if there are fewer than two.</summary>
    public double? Deviation => Near is { Count: > 1 } near ? near.SpreadMs : null;

    Plateau Near => Read.Count == 0 ? null : Plateau.NearMedian([.. Read.Select(picture => picture.VisuMs)]);

    /// <summary>Gets the reasons for rejections with the rejected pictures, the most frequent reason first.</summary>
    public IEnumerable<(string Fault, IReadOnlyList<string> Files)> Faults() => Pictures.Where(picture => !picture.IsRead)
        .GroupBy(picture => picture.Fault, picture => picture.File)
        .Select(group => (group.Key, (IReadOnlyList<string>)[.. group])).OrderByDescending(fault => fault.Item2.Count).ThenBy(fault => fault.Key, StringComparer.Ordinal);

    /// <summary>Gets the message for a series in which no picture could be read.</summary>
    public string NothingRead()
    {
        if (Pictures.Count == 0) return VlcMessages.NoPicture;
        if (Pictures.Count == 1) return $"{Pictures[0].File}: {Pictures[0].Fault}";
        var (fault, files) = Faults().First();
        return VlcMessages.NothingRead(Pictures.Count, files.Count, fault);
    }
}
