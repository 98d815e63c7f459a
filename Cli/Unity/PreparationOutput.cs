using System.Text;

namespace Nowpose.Cli.Unity;

/// <summary>Formats the changes to a project, either made or planned, as text or JSON.</summary>
static class PreparationOutput
{
    public static string Text(Preparation preparation, bool isCheck, string backup)
    {
        var text = new StringBuilder($"{preparation.Project.Root}: Unity {preparation.Project.Version}\n");
        foreach (var change in preparation.Changes) text.Append("  + ").Append(change).Append('\n');
        text.Append(Summary(preparation.Changes.Count, isCheck)).Append('\n');
        if (backup != null) text.Append(UnityProjectMessages.Backup).Append(backup).Append('\n');
        if (!isCheck) foreach (var step in preparation.NextSteps) text.Append("- ").Append(step).Append('\n');
        return text.ToString();
    }

    public static string Json(Preparation preparation, bool isCheck, string backup) => JsonText.Of(new
    {
        Project = preparation.Project.Root,
        Unity = preparation.Project.Version.Text,
        Applied = !isCheck && preparation.Changes.Count > 0,
        preparation.Changes,
        preparation.Notes,
        Next = preparation.NextSteps,
        Backup = backup,
    }) + "\n";

    static string Summary(int changes, bool isCheck)
    {
        if (changes == 0) return "Nothing to do.";
        var count = FormattableString.Invariant($"{changes} {(changes == 1 ? "change" : "changes")}");
        return isCheck ? count + " to make." : count + " made.";
    }
}
