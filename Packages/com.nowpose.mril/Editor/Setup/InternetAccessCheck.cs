namespace Nowpose.Editor.Setup
{
    sealed class InternetAccessCheck : ProjectCheck
    {
        public InternetAccessCheck()
            : base(
                "Internet Access is Require", "Android refuses connections to an app without the permission; Unity adds it by itself only "
                + "where it finds its own classes used.", "Require internet access") { }

        public override CheckResult Look(IProjectSettings project) =>
            project.AsksForInternet ? Good("the app asks for it") : Missing("left to Unity");

        public override string Fix(IProjectSettings project)
        {
            project.AsksForInternet = true;
            return null;
        }
    }
}
