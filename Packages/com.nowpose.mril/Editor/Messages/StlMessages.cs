namespace Nowpose.Editor.Messages
{
    /// <summary>Error messages about STL files, each with a remedy.</summary>
    static class StlMessages
    {
        public static string HeaderCut(string file, int offset, int headerBytes) =>
            $"{file}, byte {offset}: the file ends within its header of {headerBytes} bytes; it is not an STL file, or it is incomplete; export "
            + "it again";

        public static string NotFinite(string file, int offset, int triangle) =>
            $"{file}, byte {offset}: triangle {triangle} has a corner that is not a finite number; export it again";

        public const string SolidInSolid = "a solid is inside another solid; end the first one with endsolid, or export the mesh again";
        public const string EndSolid = "endsolid without a solid, or inside a facet; export the mesh again";
        public const string EndLoop = "endloop outside a facet; export the mesh again";

        public static string NotAKeyword(string word) => $"'{word}' is not a keyword of the STL format; export the mesh again as STL";

        public const string FacetOutside = "a facet is outside a solid, or inside another facet; export the mesh again";
        public const string EndFacet = "endfacet without a facet; export the mesh again";

        public static string Corners(int count) => $"the facet has {count} corners; it needs 3; export the mesh again";

        public const string VertexOutside = "a vertex is outside a facet; export the mesh again";
        public const string FourthCorner = "the facet has a fourth corner; it needs 3; export the mesh again as triangles";

        public static string VertexNumbers(int count) => $"a vertex has {count} numbers; it needs 3; export the mesh again";

        public const string NoEndSolid = "the file ends without endsolid, so it is incomplete; export it again";

        public static string NotANumber(string word) => $"'{word}' is not a finite number; export the mesh again";
        public static string FileTooLong(string file, long bytes, long max) => $"{file}: {bytes} bytes; the maximum is {max}; simplify the mesh";

        public const string NoTriangles = "the mesh has no triangles; it needs at least one; export the mesh again";

        public static string NoArea(int count) =>
            $"each of its {count} triangles has zero area; export the mesh again, larger or with a finer resolution";

        public static string TooMany(string file, long count, int max) =>
            $"{file}: {count} triangles or more; the maximum is {max}; simplify the mesh";

        public static string OtherLength(string file, int offset, uint triangles, long expected, long actual) => actual < expected
            ? $"{file}, byte {offset}: {triangles} triangles take {expected} bytes, but the incomplete file has {actual}; export it again"
            : $"{file}, byte {offset}: {triangles} triangles take {expected} bytes, but the file has {actual}; export it again";
    }
}
