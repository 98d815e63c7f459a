namespace Nowpose.Editor.Setup
{
    /// <summary>Action of a merge for an entry of the manifest that does not meet the requirement.</summary>
    enum ConflictRule
    {
        /// <summary>Rejects the whole merge.</summary>
        Refuse,

        /// <summary>Keeps the entry.</summary>
        Keep,

        /// <summary>Replaces the entry.</summary>
        Replace,
    }
}
