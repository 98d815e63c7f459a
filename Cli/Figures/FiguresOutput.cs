using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Figures.Pictures;
using Nowpose.Web;

namespace Nowpose.Cli.Figures;

/// <summary>The output folders of a run.</summary>
sealed class FiguresOutput
{
    readonly string _folder;
    readonly string _pictures;

    FiguresOutput(string folder, string pictures)
    {
        _folder = folder;
        _pictures = pictures;
        PagePath = Path.Combine(folder, "figures.html");
    }

    public string PagePath { get; }

    /// <summary>Paths of the pictures that were written.</summary>
    public IReadOnlyList<string> PicturePaths { get; private set; } = [];

    /// <summary>
    /// Creates the folders, checks that they are writable and removes the files of an earlier run, which could be mistaken for new ones.
    /// </summary>
    /// <param name="pictures">Folder for the pictures; null to write none.</param>
    /// <exception cref="InputException">A folder is not writable.</exception>
    public static FiguresOutput At(string folder, string pictures)
    {
        var output = new FiguresOutput(Writable("--out", folder, "figures.html"), pictures == null ? null : Writable("--pictures", pictures, ".nowpose"));
        foreach (var number in FigureSet.Numbers) File.Delete(Path.Combine(output._folder, $"figure-{number}.csv"));
        return output;
    }

    public void Write(IReadOnlyList<Figure> figures, FigureSettings settings)
    {
        foreach (var figure in figures)
        {
            using var file = File.CreateText(Path.Combine(_folder, figure.FileName));
            figure.Table.WriteCsv(file);
        }
        File.WriteAllText(PagePath, FiguresPage.Render(FiguresJson.Of(figures, settings)));
        if (_pictures != null) PicturePaths = DocumentPictures.Write(_pictures, figures);
    }

    static string Writable(string option, string folder, string trial) => OptionPath.InFolder(option, folder, full =>
    {
        var path = Path.Combine(full, trial);
        File.WriteAllText(path, "");
        File.Delete(path);
        return full;
    });
}
