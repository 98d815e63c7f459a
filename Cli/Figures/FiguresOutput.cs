using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Figures.Pictures;
using Nowpose.Gateway;
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
        if (pictures != null) pictures = OptionPath.InFolder("--pictures", pictures, full => full);
        return OptionPath.InFolder("--out", folder, full =>
        {
            var output = new FiguresOutput(full, pictures);
            foreach (var path in FigureSet.Numbers.Select(number => Path.Combine(full, $"figure-{number}.csv")).Append(output.PagePath)) File.Delete(path);
            return output;
        });
    }

    public void Write(IReadOnlyList<Figure> figures, FigureSettings settings)
    {
        foreach (var figure in figures)
            OutputFile.Write(Path.Combine(_folder, figure.FileName), figure.Table.WriteCsv);
        OutputFile.Write(PagePath, Pages.Figures.Render(FiguresJson.Of(figures, settings)));
        if (_pictures != null) PicturePaths = DocumentPictures.Write(_pictures, figures);
    }
}
